// SPDX-License-Identifier: Apache-2.0
// Files that are damaged, foreign or cannot be written: a run is as if they were not there.
#include <fstream>
#include <sstream>

#include "support/cache_fixture.hpp"

namespace polhode {
namespace {

using namespace test;
struct CacheFaults : cache_of_a_test {};

TEST_F(CacheFaults, ADamagedFileIsComputedAgain) {
  options.experiments = {"energy"};
  options.schemes = {"heun", "strang"};
  const auto first = run();
  const auto victim = files().front();
  std::ostringstream whole;
  whole << std::ifstream(victim, std::ios::binary).rdbuf();
  const auto text = whole.str();
  auto flipped = text;
  flipped[text.size() - 40] ^= 1;
  for (const auto& damaged : {std::string(), text.substr(0, 10), text.substr(0, text.size() / 2),
                              text.substr(0, text.size() - 1), flipped, text + "\n", std::string("{}")}) {
    std::ofstream(victim, std::ios::binary) << damaged;
    const auto again = run();
    EXPECT_EQ(again.done.results_computed, 1u) << damaged.size();
    EXPECT_EQ(again.done.results_reused, 1u);
    EXPECT_EQ(said(again), said(first));
    EXPECT_EQ(counted(), (counts{0, 0, 2})) << "it is whole again";
  }
}

// Two files exchanged: each is whole, and neither is of the key by which it is found.
TEST_F(CacheFaults, AFileOfAnotherKeyIsNotTaken) {
  options.experiments = {"energy"};
  options.schemes = {"lie_heun", "milstein"};  // keys of one length
  const auto first = run();
  const auto all = files();
  ASSERT_EQ(all.size(), 2u);
  fs::rename(all[0], folder / "aside"), fs::rename(all[1], all[0]), fs::rename(folder / "aside", all[1]);
  const auto again = run();
  EXPECT_EQ(again.done.results_computed, 2u);
  EXPECT_EQ(said(again), said(first));
}

TEST_F(CacheFaults, FreshReplacesWhatIsThere) {
  options.experiments = {"energy"};
  EXPECT_EQ(counted(), (counts{1, 3, 0}));
  const auto inode_times = fs::last_write_time(files().front());
  EXPECT_EQ(counted(result_folder::access::rewrite), (counts{1, 3, 0}));
  EXPECT_GT(fs::last_write_time(files().front()), inode_times);
  EXPECT_EQ(files().size(), 3u);
  EXPECT_EQ(counted(), (counts{0, 0, 3}));
}

// A folder that cannot be made, whoever asks: below a file.
TEST_F(CacheFaults, WhereNothingCanBeWrittenTheResultIsTheSame) {
  options.experiments = {"energy"};
  const auto first = run();
  const auto file = own_path("cache_file");
  std::ofstream{file} << "not a folder";
  result_folder store(file / "below");
  options.store = &store;
  const auto second = verify(scene, options);
  EXPECT_EQ(second.done.results_computed, 3u);
  EXPECT_EQ(said(second), said(first));
  EXPECT_NE(store.trouble(), "");
  fs::remove(file);
}

TEST_F(CacheFaults, TheLongestUnusedGoFirst) {
  report::results some;
  some.scene.name = std::string(10'000, 'x');
  {
    result_folder store(folder);
    for (int i = 0; i < 10; ++i) store.save("key " + std::to_string(i), some);
  }
  const auto hours_ago = fs::file_time_type::clock::now() - std::chrono::hours(2);
  for (const auto& file : files()) fs::last_write_time(file, hours_ago);
  std::ofstream{folder / "somebody's.txt"} << std::string(50'000, 'y');
  std::ofstream{folder / ".dead.unfinished"} << "z";
  std::ofstream{folder / ".alive.unfinished"} << "z";
  fs::last_write_time(folder / ".dead.unfinished", hours_ago);
  {
    result_folder store(folder, result_folder::access::use, 45'000);  // room for four
    EXPECT_TRUE(store.load("key 3"));
    EXPECT_TRUE(store.load("key 7"));
    store.save("key 10", some);
  }
  result_folder store(folder);
  int left = 0;
  for (int i = 0; i <= 10; ++i) left += store.load("key " + std::to_string(i)).has_value();
  EXPECT_EQ(left, 4);
  for (const auto* key : {"key 3", "key 7", "key 10"}) EXPECT_TRUE(store.load(key)) << key;
  EXPECT_TRUE(fs::exists(folder / "somebody's.txt"));
  EXPECT_FALSE(fs::exists(folder / ".dead.unfinished"));
  EXPECT_TRUE(fs::exists(folder / ".alive.unfinished"));
}

}  // namespace
}  // namespace polhode
