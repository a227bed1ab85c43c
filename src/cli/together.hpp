// SPDX-License-Identifier: Apache-2.0
// Processes that mpirun has started together with this one. Built without MPI there are none (alone.cpp), else
// src/mpi knows them.
#pragma once

#include <string>
#include <string_view>

#include "run/ranks.hpp"

namespace polhode::cli {

/// While it lives, in main, the others can be reached.
class together {
 public:
  together(int* argc, char*** argv);
  ~together();  // NOLINT(performance-trivially-destructible): it is with MPI that it has something to do
  together(const together&) = delete;
  together& operator=(const together&) = delete;
};

/// Null where this process is alone.
const ranks* others();
/// The first, or alone: who prints and writes.
bool speaks();
/// Of those, on this machine.
int processes_here();
/// What comes before what this process alone has to say: "rank 1 of 3: "; nothing of the first, or alone.
std::string signature();
/// Says what has failed. Where all processes come here within a second they have found the same: the first one says it,
/// and each returns, to end in order. Else who has failed says it, signed, and ends all of them with that code.
void fail(std::string_view fault, int code);

}  // namespace polhode::cli
