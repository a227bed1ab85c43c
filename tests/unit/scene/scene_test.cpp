// SPDX-License-Identifier: Apache-2.0
// Scenes: what is read.
#include "scene/scene.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "scene/builtin.hpp"
#include "scene_files.hpp"

namespace {

using polhode::load_scene;
using polhode::testing::scene_files;
using row = std::vector<double>;
using vectors = std::vector<row>;

TEST_F(scene_files, a_full_scene_is_read) {
  const auto s = load({});
  EXPECT_EQ(s.name, "given");
  EXPECT_EQ(s.system, "rigid_body");
  EXPECT_EQ(s.vector("inertia"), (row{1, 2, 3}));
  EXPECT_EQ(s.number("theta"), 0.5);
  EXPECT_EQ(s.vectors("sigma"), (vectors{{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}));
  EXPECT_EQ(s.momentum, (std::vector<double>{0.6, 0.48, 0.64}));
  EXPECT_EQ(s.horizon, 2);
  EXPECT_EQ(s.steps, (std::vector<std::int64_t>{4, 8, 16}));
}

TEST_F(scene_files, integers_do_for_numbers) {
  const auto s =
      load({{"inertia", "[1, 2, 3]"}, {"theta", "0"}, {"sigma", "1"}, {"momentum", "[0, 0, 1]"}, {"horizon", "2"}});
  EXPECT_EQ(s.vector("inertia"), (row{1, 2, 3}));
  EXPECT_EQ(s.vectors("sigma"), (vectors{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(s.horizon, 2);
}

TEST_F(scene_files, noise_in_all_its_forms) {
  struct {
    std::string given;
    vectors wanted;
  } const cases[] = {
      {"0", {}},
      {"-0.5", {{-0.5, 0, 0}, {0, -0.5, 0}, {0, 0, -0.5}}},
      {"[0.2, 0.0, 0.9]", {{0.2, 0, 0}, {0, 0, 0.9}}},
      {"[0, 0, 0]", {}},
      {"[]", {}},
      {"[[1, 2, 3]]", {{1, 2, 3}}},
      {"[[0, 0, 0], [1, -2, 3.5], [1, 0, 0], [0, 1, 0], [0, 0, 1]]", {{1, -2, 3.5}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  for (const auto& c : cases) EXPECT_EQ(load({{"sigma", c.given}}).vectors("sigma"), c.wanted) << c.given;
}

TEST_F(scene_files, name_and_steps_have_defaults) {
  const auto s = load_scene(write(with({{"name", ""}, {"steps", ""}}), "my scene.toml"));
  EXPECT_EQ(s.name, "my scene");
  EXPECT_EQ(s.steps, (std::vector<std::int64_t>{4, 8, 16, 32, 64}));
}

TEST_F(scene_files, odd_but_good) {
  EXPECT_EQ(load({{"name", "'</script> & θ'"}}).name, "</script> & θ");
  EXPECT_EQ(load({{"steps", "[5000]"}}).steps.size(), 1U);
  EXPECT_EQ(load({{"inertia", "[1e-300, 1e300, 1]"}}).vector("inertia")[1], 1e300);
  EXPECT_EQ(load_scene(write("\xef\xbb\xbf" + with({}))).name, "given");
}

TEST(builtin_scenes, are_good_and_named_like_their_files) {
  const auto names = polhode::builtin_scenes();
  ASSERT_FALSE(names.empty());
  EXPECT_EQ(names.front(), "paper");
  for (const auto& name : names) EXPECT_EQ(load_scene(name).name, name);
  for (const auto& entry : polhode::builtin_scene_table()) EXPECT_FALSE(entry.title.empty()) << entry.name;
}

TEST(builtin_scenes, paper_is_the_scene_of_the_known_answers) {
  const auto s = load_scene("paper");
  EXPECT_EQ(s.vector("inertia"), (row{1, 2, 3}));
  EXPECT_EQ(s.number("theta"), 0.5);
  EXPECT_EQ(s.vectors("sigma"), (vectors{{0.5, 0, 0}, {0, 0.5, 0}, {0, 0, 0.5}}));
  EXPECT_EQ(s.momentum, (std::vector<double>{0.6, 0.48, 0.64}));
  EXPECT_EQ(s.horizon, 2);
  EXPECT_EQ(s.steps, (std::vector<std::int64_t>{4, 8, 16, 32, 64}));
}

TEST(builtin_scenes, cover_what_a_scene_may_lack) {
  EXPECT_TRUE(load_scene("free").vectors("sigma").empty());
  EXPECT_EQ(load_scene("free").number("theta"), 0);
  EXPECT_TRUE(load_scene("dissipative").vectors("sigma").empty());
  EXPECT_EQ(load_scene("undamped").number("theta"), 0);
  EXPECT_EQ(load_scene("single").vectors("sigma").size(), 1U);
  EXPECT_EQ(load_scene("anisotropic").vectors("sigma"), (vectors{{0.2, 0, 0}, {0, 0.5, 0}, {0, 0, 0.9}}));
  EXPECT_EQ(load_scene("symmetric").vector("inertia"), (row{1, 1, 2.5}));
}

}  // namespace
