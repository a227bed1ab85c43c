// SPDX-License-Identifier: Apache-2.0
// What the tests of scenes share: scenes as files, and what a refusal must be.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "reports/model/errors.hpp"
#include "scene/scene.hpp"
#include "support/own_path.hpp"

namespace polhode::testing {

namespace fs = std::filesystem;

/// Writes scenes into a folder of the test's own.
class scene_files : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = test::own_path("scene");
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string write(const std::string& text, const std::string& name = "given.toml") const {
    const auto path = folder_ / name;
    std::ofstream{path, std::ios::binary} << text;
    return path.string();
  }

  /// A good scene with some keys replaced; an empty value leaves the key out.
  static std::string with(const std::map<std::string, std::string>& changes) {
    std::map<std::string, std::string> keys{
        {"name", "'given'"}, {"system", "'rigid_body'"}, {"inertia", "[1.0, 2.0, 3.0]"},    {"theta", "0.5"},
        {"sigma", "0.5"},    {"horizon", "2.0"},         {"momentum", "[0.6, 0.48, 0.64]"}, {"steps", "[4, 8, 16]"}};
    for (const auto& [key, value] : changes) keys[key] = value;
    std::string text;
    for (const auto& [key, value] : keys)
      if (!value.empty()) text += key + " = " + value + '\n';
    return text;
  }

  polhode::scene load(const std::map<std::string, std::string>& changes) const {
    return load_scene(write(with(changes)));
  }

  /// The message of the refusal; empty if there was none.
  static std::string refusal(const std::string& path) {
    try {
      load_scene(path);
    } catch (const polhode::input_error& fault) {
      return fault.what();
    }
    return {};
  }

  static void expect_refused(const std::string& path, const std::vector<std::string>& fragments) {
    const auto message = refusal(path);
    EXPECT_FALSE(message.empty()) << path << " was accepted";
    EXPECT_EQ(message.find('\n'), message.npos) << message;
    EXPECT_LT(message.size(), 700U);
    for (const auto& fragment : fragments)
      EXPECT_NE(message.find(fragment), message.npos) << fragment << " in: " << message;
  }

  fs::path folder_;
};

}  // namespace polhode::testing
