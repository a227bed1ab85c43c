// SPDX-License-Identifier: Apache-2.0
// Pairs of runs of one program, as they are on this machine now: what `compare` calls changed, and whether a kernel
// that does one step in twenty twice is found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "comparison/compare.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/kernel_decorator.hpp"

namespace polhode {
namespace {

constexpr const char* slowed = "lie_heun";

/// Advances as the kernel does, and one step in twenty once more, on a copy.
class slower_kernel final : public test::kernel_decorator {
 public:
  using kernel_decorator::advance, kernel_decorator::kernel_decorator;
  void advance(std::span<double> states, const increment_view& w, piece part) const override {
    if (++calls_ % 5 != 0) {  // of sixteen steps each
      scratch_.assign(states.begin(), states.end());
      kernel_decorator::advance(scratch_, w.part(0, 1), part);
    }
    kernel_decorator::advance(states, w, part);
  }

 private:
  mutable std::vector<double> scratch_;
  mutable int calls_ = 0;
};

report::results timed(bool slower) {
  auto subject = bind_scene(load_scene("paper"));
  const auto with = subject.with;
  verify_options options;
  options.schemes = {"heun", "euler_maruyama", "lie_euler", "lie_heun", "cayley_heun", "strang", "magnus"};
  options.experiments = {"energy", "work_precision"};
  options.effort = effort::quick;
  const auto slow = [](polhode::subject s) {
    for (auto& e : s.schemes)
      if (e.info.name == slowed)
        e.make = [make = e.make](double dt) { return std::make_unique<slower_kernel>(make(dt)); };
    return s;
  };
  if (slower) {
    subject = slow(subject);
    subject.with = [with, slow](const report::scene& s) { return slow(with(s)); };
  }
  return verify_subject(subject, options);
}

/// Both runs found the machine as it was; else `compare` says below what it tells nothing.
bool in_one_state(const report::comparison& c) { return c.settings.empty(); }

TEST(Timings, OneAlarmInAHundredAtMostAndAFivePerCentSlowerKernelIsFound) {
  constexpr int pairs = 20;
  std::size_t compared = 0, alarms = 0;
  int found = 0, asked = 0;
  for (int i = 0; i < pairs; ++i) {
    const auto a = timed(false), b = timed(false), c = timed(true);
    const auto same = compare(a, b), planted = compare(b, c);
    compared += same.timings;
    alarms += same.changes.size();
    for (const auto& x : same.changes) std::printf("%s: %s: %g\n", x.scheme.c_str(), x.what.c_str(), *x.after);
    if (!in_one_state(planted)) continue;
    ++asked;
    found += std::ranges::any_of(planted.changes, [](const auto& x) { return x.scheme == slowed && *x.after > 1; });
  }
  std::printf(
      "%zu alarms over %zu timings in %d pairs; slower kernel found in %d of %d pairs on a machine in one state\n",
      alarms, compared, pairs, found, asked);
  EXPECT_GT(compared, 0u);
  EXPECT_GT(asked, 0) << "the machine was never in one state: nothing is known of the slower kernel";
  EXPECT_LE(static_cast<double>(alarms), 0.01 * static_cast<double>(compared));
  EXPECT_GE(10 * found, 9 * asked);
}

}  // namespace
}  // namespace polhode
