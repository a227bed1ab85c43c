// SPDX-License-Identifier: Apache-2.0
// States that somebody recorded: of one path or many, at times of their own, in a file.
//
// CSV: a line of names, [path,]t,mu_1,…, in any order, under the system's own names of components or mu_k; lines that
// begin with # are not read. NPY: an array [path][time][component], or [time][component] of one path, of doubles or
// floats, little endian, in C order; states come every dt. The file is read once, from front to back, whatever its
// size.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace polhode {

struct recorded_state {
  std::int64_t path = 0;
  double time = 0;
  std::span<const double> mu;
  std::uint64_t place = 0;  ///< its line; in an array: which of all states, from 1
};

struct recording {
  std::filesystem::path file;
  std::vector<std::string> components;  ///< the system's names
  std::optional<double> dt;             ///< of an array, > 0
};

/// What was read.
struct recording_size {
  std::uint64_t states = 0;
  double resolution = 0;  ///< of a number, relative: by its digits, or by its type
};

using state_sink = std::function<void(const recorded_state&)>;

/// Hands over every state in the order of the file. Throws input_error, one line, on what is no recording of such
/// states.
recording_size read_recording(const recording&, const state_sink&);

/// "data.csv: line 7", "data.npy: state 7": where a state stands.
std::string place_of(const recording&, std::uint64_t place);

}  // namespace polhode
