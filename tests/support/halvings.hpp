// SPDX-License-Identifier: Apache-2.0
// Step sizes that halve from 1/8 on.
#pragma once

#include <cmath>
#include <vector>

namespace polhode::test {

inline std::vector<double> halvings(int levels) {
  std::vector<double> dt;
  for (int i = 0; i < levels; ++i) dt.push_back(std::exp2(-3 - i));
  return dt;
}

}  // namespace polhode::test
