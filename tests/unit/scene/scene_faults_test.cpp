// SPDX-License-Identifier: Apache-2.0
// Every fault of a scene is refused in one line that names the file, the key and the value.
#include <gtest/gtest.h>

#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "reports/model/text.hpp"
#include "scene/builtin.hpp"
#include "scene_files.hpp"

namespace {

using polhode::testing::scene_files;

TEST_F(scene_files, bad_values_are_refused_by_name) {
  const std::map<std::string, std::vector<std::string>> bad{
      {"name", {"''", "' '", "3", "\"a\\nb\"", "\"\\u001b[0m\"", "'" + std::string(101, 'x') + "'"}},
      {"system", {"'rigidbody'", "''", "1", "['rigid_body']"}},
      {"inertia",
       {"[0.0, 1.0, 2.0]", "[-1, 2, 3]", "[1.0, 2.0]", "[1, 2, 3, 4]", "['a', 1.0, 2.0]", "1.0", "[]",
        "[nan, 1.0, 2.0]", "[inf, 1.0, 2.0]", "[[1], 2, 3]", "{ a = 1 }", "[true, 1, 2]"}},
      {"theta", {"-1.0", "-1e-300", "nan", "inf", "-inf", "'0.5'", "true", "[0.5]", "1979-05-27"}},
      {"sigma",
       {"'x'", "nan", "inf", "[1, 2]", "[1, 2, 3, 4]", "[[1, 2]]", "[[1, 2, 3], 4]", "[1, [1, 2, 3], 2]",
        "[[1, 2, nan]]", "[1, 2, inf]", "{}"}},
      {"momentum", {"[0.0, 0.0, 0.0]", "[0, 0, -0.0]", "[1, 2]", "[1, 2, 3, 4]", "[nan, 0, 1]", "'x'", "1"}},
      {"horizon", {"0", "-1.0", "nan", "inf", "'2'", "[2]"}},
      {"steps",
       {"[8, 4]", "[4, 4]", "[0, 4]", "[-4, 4]", "[4.0, 8.0]", "[]", "4", "['4']", "[1000000001]",
        "[9223372036854775807]"}}};
  for (const auto& [key, values] : bad) {
    for (const auto& value : values) {
      SCOPED_TRACE(key + " = " + value);
      const auto shown = value.size() < 20 && value.front() == '\'' ? value.substr(1, value.size() - 2) : std::string{};
      expect_refused(write(with({{key, value}})), {"given.toml:", key + " = ", "accepted: ", shown});
    }
  }
}

TEST_F(scene_files, the_refused_value_is_shown) {
  struct {
    std::string key, value;
  } const cases[] = {{"theta", "-1.0"},
                     {"theta", "nan"},
                     {"theta", "inf"},
                     {"theta", "-0.4"},
                     {"horizon", "-1.0"},
                     {"steps", "8, 4"},
                     {"momentum", "0.0, 0.0, 0.0"},
                     {"inertia", "0.0, 1.0, 2.0"},
                     {"inertia", "0.1, -1e-300, 1e+300"},
                     {"sigma", "1, 2"},
                     {"system", "rigidbody"}};
  for (const auto& c : cases) {
    const bool list = c.value.find(',') != c.value.npos, quoted = c.key == "system";
    const auto written = list ? "[" + c.value + "]" : quoted ? "'" + c.value + "'" : c.value;
    expect_refused(write(with({{c.key, written}})), {c.key + " = ", c.value});
  }
  expect_refused(write(with({{"system", "'rigidbody'"}})), {"did you mean 'rigid_body'?"});
}

TEST_F(scene_files, the_line_is_named) {
  expect_refused(write("# one\n# two\n" + with({{"horizon", "-2"}})), {"given.toml:3: horizon = -2"});
}

TEST_F(scene_files, missing_keys_are_named) {
  for (const std::string key : {"system", "inertia", "theta", "sigma", "momentum", "horizon"})
    expect_refused(write(with({{key, ""}})), {"given.toml", key + " is missing", "accepted: "});
}

TEST_F(scene_files, unknown_keys_are_named_with_the_nearest) {
  expect_refused(write(with({{"thta", "1.0"}})), {"thta = 1.0", "unknown key", "did you mean 'theta'?"});
  expect_refused(write(with({{"Inertia", "[1, 2, 3]"}})), {"Inertia = ", "did you mean 'inertia'?"});
  expect_refused(write(with({{"zzzzzzzzz", "1"}})), {"zzzzzzzzz = 1", "accepted: name, system"});
  expect_refused(write(with({}) + "[heat]\nkind = 'x'\n"), {"heat = ", "unknown key"});
  expect_refused(write(with({}) + "\"\\u001b[31m\" = 1\n"), {"\\x1b[31m = 1"});
}

TEST_F(scene_files, the_line_that_has_to_go_is_named) {
  const auto versioned = write("schema = 1\n" + with({}));
  expect_refused(versioned, {"given.toml:1: schema = 1: ", "delete this line"});
  EXPECT_EQ(refusal(versioned).find("did you mean"), std::string::npos);
  expect_refused(write("[body]\n" + with({})), {"given.toml:1: body = ", "move its keys to the top level"});
}

TEST_F(scene_files, what_is_no_scene_file_is_refused) {
  expect_refused((folder_ / "none.toml").string(), {"none.toml", "No such file"});
  expect_refused(folder_.string(), {folder_.string(), "directory"});
  expect_refused(write(""), {"given.toml", "empty"});
  expect_refused(write("# only a comment\n"), {"given.toml", "no keys"});
  expect_refused(write(with({}) + "# " + std::string(1U << 20U, 'x')), {"given.toml", "1 MiB"});
  expect_refused(write("name = \n"), {"given.toml:1", "not TOML"});
  expect_refused(write("{\"name\": 1}\n"), {"given.toml:1", "not TOML"});
  expect_refused(write(with({}) + "theta = 1.0\n"), {"given.toml:9", "not TOML"});
  expect_refused(write(with({}) + "\xff\xfe\n"), {"given.toml", "not TOML"});
  expect_refused(write(std::string(64, '\0')), {"given.toml", "not TOML"});
  expect_refused(write("a = " + std::string(100000, '[')), {"given.toml:1", "not TOML"});
  expect_refused(write(with({{"theta", "99999999999999999999"}})), {"given.toml", "not TOML"});
}

TEST_F(scene_files, strange_file_names_stay_on_one_line) {
  expect_refused((folder_ / "a\nb.toml").string(), {"a b.toml"});
  expect_refused(write(with({{"name", ""}}), "a\x01z.toml"), {"a\\x01z.toml", "name"});
}

TEST_F(scene_files, unknown_names_get_the_nearest) {
  expect_refused("papr", {"papr", "no such scene", "did you mean 'paper'?", "symmetric"});
  expect_refused("", {"no such scene"});
}

TEST_F(scene_files, a_path_is_not_a_name) {
  expect_refused("./paper", {"./paper", "No such file"});
  expect_refused("paper.toml", {"paper.toml", "No such file"});
}

/// The text with each of its lines "key = value" in turn given another value.
std::vector<std::string> with_each_value(std::string_view text, const std::string& value) {
  std::vector<std::string> lines, out;
  std::istringstream in{std::string(text)};
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  for (std::size_t changed = 0; changed < lines.size(); ++changed) {
    const auto at = lines[changed].find(" = ");
    if (lines[changed].starts_with('#') || at == std::string::npos) continue;
    std::string one;
    for (std::size_t i = 0; i < lines.size(); ++i)
      one += (i == changed ? lines[i].substr(0, at + 3) + value : lines[i]) + '\n';
    out.push_back(one);
  }
  return out;
}

TEST_F(scene_files, every_key_of_every_system_given_another_shape_is_taken_or_refused) {
  int refused = 0;
  for (const auto& entry : polhode::builtin_scene_table()) {
    for (const char* never : {"[[[1]]]", "[1, [1]]", "[[], 1]", "{}", "1979-05-27"})
      for (const auto& text : with_each_value(entry.text, never)) EXPECT_FALSE(refusal(write(text)).empty()) << text;
    for (const char* odd : {"[]", "[[]]", "[[], []]", "[0]", "[[0]]", "0", "-1", "nan", "inf", "''", "false", "[1, 2]"})
      for (const auto& text : with_each_value(entry.text, odd)) {
        const auto said = refusal(write(text));
        EXPECT_TRUE(polhode::is_plain_text(said)) << said;
        refused += !said.empty();
      }
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
