// SPDX-License-Identifier: Apache-2.0
// Numbers that whoever runs a long test may set.
#pragma once

#include <cstdlib>

namespace polhode::test {

inline int from_environment(const char* name, int otherwise) {
  const char* text = std::getenv(name);
  return text ? std::atoi(text) : otherwise;
}

}  // namespace polhode::test
