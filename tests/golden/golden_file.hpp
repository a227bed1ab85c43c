// SPDX-License-Identifier: Apache-2.0
// A text against a committed file, byte for byte; written anew where POLHODE_UPDATE_GOLDEN is set.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

namespace polhode::golden {

inline void expect_golden(const std::string& text, const std::string& name) {
  const std::string path = std::string(POLHODE_GOLDEN_DATA) + "/" + name;
  if (std::getenv("POLHODE_UPDATE_GOLDEN") != nullptr) {
    std::ofstream(path, std::ios::binary) << text;
    GTEST_SKIP() << "wrote " << path;
  }
  std::ifstream file(path, std::ios::binary);
  ASSERT_TRUE(file) << path << " is missing; set POLHODE_UPDATE_GOLDEN=1 to write it";
  std::ostringstream golden;
  golden << file.rdbuf();
  EXPECT_EQ(golden.str(), text);
}

}  // namespace polhode::golden
