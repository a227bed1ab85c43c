// SPDX-License-Identifier: Apache-2.0
// What a second run computes again, by counters; and that it says what a first run says, bit for bit.
#include <algorithm>
#include <atomic>
#include <map>
#include <set>

#include "experiments/common/noise_verdict.hpp"
#include "platform/isa.hpp"
#include "run/cache_key.hpp"
#include "support/cache_fixture.hpp"
#include "support/noise_defects.hpp"

namespace polhode {
namespace {

using namespace test;
struct Cache : cache_of_a_test {};

TEST_F(Cache, ASecondRunComputesNothingAndSaysTheSame) {
  const auto first = run(), second = run();
  EXPECT_EQ(first.done.experiments_run, 2u);
  EXPECT_EQ(first.done.results_computed, 6u);
  EXPECT_EQ(first.reused.size(), 0u);
  EXPECT_EQ(second.done.experiments_run, 0u);
  EXPECT_EQ(second.done.results_computed, 0u);
  EXPECT_EQ(second.done.results_reused, 6u);
  EXPECT_EQ(second.done.work, report::counters{});
  EXPECT_EQ(said(second), said(first));
  double saved = 0;
  for (const auto& one : second.reused) {
    EXPECT_GE(one.computed, first.provenance.started);
    EXPECT_LE(one.computed, second.provenance.started);
    saved += one.saved.cpu_seconds;
  }
  EXPECT_GT(saved, 0);
  EXPECT_LE(saved, first.provenance.cpu_seconds * (1 + 1e-9));
}

TEST_F(Cache, OnlyWhatIsNewIsComputed) {
  options.experiments = {"energy"};
  options.schemes = {"heun", "strang"};
  EXPECT_EQ(counted(), (counts{1, 2, 0}));
  options.schemes = {"heun", "magnus", "strang"};
  EXPECT_EQ(counted(), (counts{1, 1, 2})) << "one scheme more";
  options.experiments = {"energy", "strong"};
  EXPECT_EQ(counted(), (counts{1, 3, 3})) << "one experiment more";
  options.schemes = {"magnus"};
  EXPECT_EQ(counted(), (counts{0, 0, 2})) << "fewer schemes";
}

/// A cached scheme does not speak for the noise that the others are run on now.
TEST_F(Cache, TheNoiseOfWhatIsComputedNowIsJudged) {
  options.experiments = {"strong"};
  options.schemes = {"heun"};
  run();
  options.schemes = {"heun", "magnus"};
  const channels_correlated defect(1);
  const planted_noise_defect planted(defect);
  std::vector<report::verdict_kind> found;
  for (const auto& v : run().verdicts)
    if (v.scheme == noise_name && v.claim == noise_claim) found.push_back(v.kind);
  EXPECT_EQ(found, (std::vector{report::verdict_kind::refuted, report::verdict_kind::holds})) << "this run's first";
}

/// The subject, its kernels counted as they are made, by scheme and whatever verify() says.
subject counted_subject(subject s, std::map<std::string, std::atomic<int>>& made) {
  for (auto& scheme : s.schemes)
    scheme.make = [&count = made[std::string(scheme.info.name)], make = scheme.make](double dt) {
      ++count;
      return make(dt);
    };
  s.with = [&made, with = s.with](const report::scene& other) { return counted_subject(with(other), made); };
  return s;
}

TEST_F(Cache, KernelsAreMadeForWhatIsNewOnly) {
  const auto made = [&] {
    std::map<std::string, std::atomic<int>> count;
    result_folder store(folder);
    options.store = &store;
    verify_subject(counted_subject(bind_scene(scene), count), options);
    std::vector<std::string> names;
    for (const auto& [name, times] : count)
      if (times > 0) names.push_back(name);
    return names;
  };
  using names = std::vector<std::string>;
  options.schemes = {"heun", "strang"};
  EXPECT_EQ(made(), (names{"heun", "strang"}));
  EXPECT_EQ(made(), names{});
  options.schemes = {"heun", "magnus", "strang"};
  EXPECT_EQ(made(), names{"magnus"});
  scene.vectors("sigma")[0][0] = 0.25;
  EXPECT_EQ(made(), options.schemes);
}

TEST_F(Cache, EveryInputCounts) {
  options.experiments = {"energy"};
  options.schemes = {"heun"};
  const counts computed{1, 1, 0}, reused{0, 0, 1};
  EXPECT_EQ(counted(), computed);
  const auto changed = [&](const char* what, auto change) {
    const auto scene_before = scene;
    const auto options_before = options;
    change();
    EXPECT_EQ(counted(), computed) << what;
    EXPECT_EQ(counted(), reused) << what;
    scene = scene_before;
    options = options_before;
    EXPECT_EQ(counted(), reused) << "back from " << what;
  };
  changed("sigma", [&] { scene.vectors("sigma")[1][1] = 0.5000000000000001; });
  changed("no sigma", [&] { scene.vectors("sigma").clear(); });
  changed("theta", [&] { scene.number("theta") = 0.25; });
  changed("inertia", [&] { scene.vector("inertia")[2] = 3.5; });
  changed("momentum", [&] { scene.momentum[0] = 0.61; });
  changed("horizon", [&] { scene.horizon = 1; });
  changed("steps", [&] { scene.steps.push_back(128); });
  changed("seed", [&] { options.seed = 2; });
  changed("effort", [&] { options.effort = effort::standard; });
}

TEST_F(Cache, NameAndThreadsDoNot) {
  const auto first = run();
  scene.name = "another";
  options.threads = 1;
  auto second = run();
  EXPECT_EQ(second.done.results_computed, 0u);
  EXPECT_EQ(second.scene.name, "another");
  second.scene.name = first.scene.name;
  EXPECT_EQ(said(second), said(first));
}

TEST_F(Cache, AKeySaysFromWhatItWasMade) {
  const auto subject = bind_scene(scene);
  const auto key = cache_key({subject}, "energy", "heun");
  for (const auto* part : {"experiment energy\n", "scheme heun\n", "effort standard\n", "seed 1\n", "isa ",
                           "inertia [[1, 2, 3]]\n", "theta [[0.5]]\n", "momentum [0.6, 0.48, 0.64]\n", "version ",
                           "commit ", "flags ", "CRC-64 ", "libraries ", "cpu "})
    EXPECT_NE(key.find(part), key.npos) << part << "in\n" << key;
  EXPECT_EQ(key.find(scene.name), key.npos);
}

TEST_F(Cache, InstructionSetsAreKeptApart) {
  const auto before = active_isa();
  std::set<std::string> keys;
  for (const auto level : usable_isas()) {
    choose_isa(level);
    keys.insert(cache_key({bind_scene(scene)}, "energy", "heun"));
  }
  choose_isa(before);
  EXPECT_EQ(keys.size(), usable_isas().size());
}

}  // namespace
}  // namespace polhode
