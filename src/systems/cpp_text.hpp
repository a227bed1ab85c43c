// SPDX-License-Identifier: Apache-2.0
// Numbers of a scene as C++ has them: for the program that `select` prints.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

#include "problem/drives.hpp"

namespace polhode {

/// {a, b, …}
inline std::string list_in_cpp(const std::vector<double>& values) {
  return fmt::format("{{{}}}", fmt::join(values, ", "));
}

/// {{a, b, …}, …}
inline std::string rows_in_cpp(const report::number_rows& rows) {
  std::vector<std::string> out;
  for (const auto& row : rows) out.push_back(list_in_cpp(row));
  return fmt::format("{{{}}}", fmt::join(out, ", "));
}

/// Declares `sigma`, the noise vectors of a system whose size is known at run time.
inline std::string noise_in_cpp(const report::scene& s) {
  return fmt::format("  const std::vector<std::vector<double>> sigma{};\n", rows_in_cpp(noise_vectors_of(s)));
}

}  // namespace polhode
