// SPDX-License-Identifier: Apache-2.0
// Processes that mpirun has started together with this one. Built without MPI there are none (alone.cpp), else
// src/mpi knows them.
#pragma once

#include "run/ranks.hpp"

namespace polhode::cli {

/// While it lives, in main, the others can be reached.
class together {
 public:
  together(int* argc, char*** argv);
  ~together();
  together(const together&) = delete;
  together& operator=(const together&) = delete;
};

/// Null where this process is alone.
const ranks* others();
/// The first, or alone: who prints and writes.
bool speaks();
/// Of those, on this machine.
int processes_here();
/// "rank 1 of 3: ", in front of what a process says that does not speak for all; empty for the first.
std::string signature();
/// One has failed: ends all of them. Returns where this process is alone.
void end_all(int code);

}  // namespace polhode::cli
