// SPDX-License-Identifier: Apache-2.0
// Tests keep freed memory as the command does, which saves a fifth of the time of those that build large matrices.
#include <gtest/gtest.h>

#include "cli/freed_memory.hpp"

int main(int argc, char** argv) {
  polhode::cli::keep_freed_memory();
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
