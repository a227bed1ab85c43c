// SPDX-License-Identifier: Apache-2.0
// The folder is complete or not there: under refusals, full disks and SIGKILL.
#include "reports/writers/folder.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "reports/model/errors.hpp"
#include "reports/writers/json.hpp"
#include "tests/golden/sample.hpp"

namespace polhode::golden {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

class folder : public testing::Test {
 protected:
  folder() {
    std::string name = (fs::temp_directory_path() / "polhode-folder-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary directory");
    root = name;
  }
  ~folder() override { fs::remove_all(root); }

  std::vector<std::string> names(const fs::path& where) const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(where)) found.push_back(entry.path().filename().string());
    std::sort(found.begin(), found.end());
    return found;
  }
  void write(const fs::path& out, unsigned seed = 1) const {
    auto r = sample_named("paper");
    r.provenance.seed = seed;
    const report::results all[] = {r};
    report::write_report(out, all);
  }
  std::uint64_t seed_in(const fs::path& out) const {
    return report::from_json(text_of(out / "paper" / "results.json")).provenance.seed;
  }

  // Runs the work in a child; its exit code, or minus its signal.
  template <class Work>
  int in_child(Work work) const {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(work());
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

  // Every write beyond the first kilobytes fails, as on a full disk; 0 where the failure was reported as it should be.
  int write_on_full_disk(const fs::path& out) const {
    return in_child([&] {
      ::signal(SIGXFSZ, SIG_IGN);
      const rlimit little{6000, 6000};
      ::setrlimit(RLIMIT_FSIZE, &little);
      try {
        write(out, 2);
      } catch (const output_error& error) {
        const std::string what = error.what();
        return what.find((out / "paper").string()) != std::string::npos &&
                       what.find("File too large") != std::string::npos
                   ? 0
                   : 3;
      } catch (...) {
        return 2;
      }
      return 1;
    });
  }

  const std::vector<std::string> complete{"digest.json", "junit.xml",    "measurements.csv", "report.html",
                                          "report.md",   "results.json", "verdicts.csv"};
  fs::path root;
};

TEST_F(folder, a_new_one_appears_whole_with_its_parents) {
  write(root / "a" / "b" / "out");
  EXPECT_EQ(names(root / "a" / "b"), std::vector<std::string>{"out"});
  EXPECT_EQ(names(root / "a" / "b" / "out" / "paper"), complete);
}

TEST_F(folder, a_report_is_exchanged_and_others_stay) {
  const report::results both[] = {sample_named("paper"), sample()};
  report::write_report(root / "out", both);
  write(root / "out" / "", 7);
  EXPECT_EQ(seed_in(root / "out"), 7u);
  EXPECT_EQ(names(root / "out").size(), 2u);
}

TEST_F(folder, an_empty_folder_and_a_link_to_it_are_taken) {
  fs::create_directory(root / "out");
  fs::create_directory_symlink(root / "out", root / "link");
  write(root / "link");
  EXPECT_EQ(seed_in(root / "out"), 1u);
  EXPECT_TRUE(fs::is_symlink(root / "link"));
}

TEST_F(folder, what_is_not_ours_is_refused_and_untouched) {
  const auto refused = [&](const fs::path& out) {
    EXPECT_THROW(report::check_output_folder(out), input_error) << out;
    EXPECT_THROW(write(out), input_error) << out;
  };
  fs::create_directories(root / "file");
  std::ofstream(root / "file" / "notes.txt") << "mine";
  refused(root / "file");
  refused(root / "file" / "notes.txt");
  refused(root / "file" / "notes.txt" / "below");
  fs::create_directories(root / "dir" / "paper");
  refused(root / "dir");
  write(root / "ours");
  std::ofstream(root / "ours" / "paper" / "notes.txt") << "mine";
  refused(root / "ours");
  fs::create_directories(root / "json" / "paper");
  std::ofstream(root / "json" / "paper" / "results.json") << "{\"schema\":{\"name\":\"other\"}}";
  refused(root / "json");
  fs::create_symlink(root / "nowhere", root / "dangling");
  refused(root / "dangling");
  refused("");
  EXPECT_EQ(text_of(root / "file" / "notes.txt"), "mine");
  EXPECT_EQ(text_of(root / "ours" / "paper" / "notes.txt"), "mine");
}

TEST_F(folder, two_scenes_of_one_name_are_refused) {
  const std::vector both(2, sample_named("paper"));
  EXPECT_THROW(report::write_report(root / "out", both), input_error);
  EXPECT_TRUE(names(root).empty());
}

TEST_F(folder, the_early_check_creates_nothing) {
  report::check_output_folder(root / "a" / "b");
  EXPECT_TRUE(names(root).empty());
  if (fs::exists("/proc/sys/kernel/ostype")) {
    EXPECT_THROW(report::check_output_folder("/proc/sys/kernel/ostype/out"), input_error);
  }
}

TEST_F(folder, a_full_disk_leaves_nothing_behind) {
  EXPECT_EQ(write_on_full_disk(root / "a" / "out"), 0);
  EXPECT_TRUE(names(root).empty());
}

TEST_F(folder, a_full_disk_leaves_the_old_report) {
  write(root / "out", 1);
  EXPECT_EQ(write_on_full_disk(root / "out"), 0);
  EXPECT_EQ(seed_in(root / "out"), 1u);
  EXPECT_EQ(names(root / "out"), std::vector<std::string>{"paper"});
}

TEST_F(folder, a_killed_writer_leaves_a_whole_report_or_none) {
  for (unsigned delay = 0; delay < 40; ++delay) {
    const auto out = root / std::to_string(delay % 8);  // new and old
    const pid_t child = ::fork();
    if (child == 0) {
      for (unsigned seed = 0;; ++seed) write(out, seed);
    }
    ::usleep(200 + 700 * delay);
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    if (!fs::exists(out / "paper")) continue;
    EXPECT_EQ(names(out / "paper"), complete);
    EXPECT_NO_THROW(seed_in(out));
  }
  for (unsigned i = 0; i < 8; ++i) write(root / std::to_string(i));
  EXPECT_EQ(names(root).size(), 8u) << "what the dead left is gone";
  for (unsigned i = 0; i < 8; ++i) EXPECT_EQ(names(root / std::to_string(i)).size(), 1u);
}

TEST_F(folder, only_what_the_dead_left_is_removed) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  write(root / "out");
  const auto dead = root / "out" / (".paper.partial-" + std::to_string(child)),
             alive = root / "out" / (".paper.partial-" + std::to_string(::getppid()));
  fs::create_directories(dead / "rest");
  fs::create_directories(alive);
  write(root / "out", 5);
  EXPECT_FALSE(fs::exists(dead));
  EXPECT_TRUE(fs::exists(alive));
  EXPECT_EQ(seed_in(root / "out"), 5u);
}

}  // namespace
}  // namespace polhode::golden
