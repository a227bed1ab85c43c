// SPDX-License-Identifier: Apache-2.0
// Step sizes that halve.
#pragma once

#include <cmath>
#include <vector>

namespace polhode::test {

inline std::vector<double> halvings(int levels, double coarsest = 0.125) {
  std::vector<double> dt;
  for (int i = 0; i < levels; ++i) dt.push_back(std::ldexp(coarsest, -i));
  return dt;
}

}  // namespace polhode::test
