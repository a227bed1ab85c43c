// SPDX-License-Identifier: Apache-2.0
// A path that no other test uses, of this build or of another one that is tested at the same time.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string_view>

namespace polhode::test {

inline std::filesystem::path own_path(std::string_view what) {
  return std::filesystem::path{::testing::TempDir()} /
         fmt::format("polhode_{}_{}_{}", what, ::testing::UnitTest::GetInstance()->current_test_info()->name(),
                     ::getpid());
}

}  // namespace polhode::test
