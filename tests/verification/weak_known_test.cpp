// SPDX-License-Identifier: Apache-2.0
// Weak errors and stationary bias without sampling: the known answers, for any number of threads.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "reports/writers/json.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/verdicts.hpp"

namespace polhode {
namespace {

using test::quick_results;

double value_at(const report::results& r, std::string_view scheme, std::string_view quantity,
                std::string_view observable, int steps) {
  for (const auto& m : r.measurements)
    if (m.scheme == scheme && m.quantity == quantity && m.observable == observable && m.method == "transfer" &&
        std::fabs(*m.dt() - 2.0 / steps) < 1e-12)
      return *m.value;
  return std::nan("");
}

struct known_error {
  const char *scheme, *quantity, *observable;
  std::vector<double> values;  // n = 4, 8, 16, 32
  double relative;             // of the printed digits
};

void expect_known(const report::results& r, const known_error& k) {
  int steps = 4;
  for (const double value : k.values) {
    EXPECT_NEAR(value_at(r, k.scheme, k.quantity, k.observable, steps), value, k.relative * value)
        << k.scheme << ' ' << k.observable << ' ' << steps;
    steps *= 2;
  }
}

// Written apart from this project: numpy, scalar steps, dense exponential. strang_weak2 at n = 4 with nine Hermite
// nodes; seven leave 2e-7.
TEST(Weak, ErrorsAreTheKnownOnes) {
  const auto r = quick_results(load_scene("paper"), {"weak"},
                               {"lie_euler", "implicit_midpoint", "strang_two_turns", "strang_weak2"});
  expect_known(r, {"lie_euler", "error", "energy", {8.429e-3, 4.329e-3, 2.186e-3, 1.098e-3}, 1e-3});
  expect_known(r, {"implicit_midpoint", "error", "energy", {4.82e-4, 2.79e-4, 1.51e-4, 7.90e-5}, 4e-3});
  expect_known(r, {"strang_two_turns", "error", "energy", {3.0972e-4, 7.7668e-5, 1.9430e-5, 4.8580e-6}, 1e-4});
  expect_known(r, {"strang_two_turns", "error", "pi3", {4.4170e-4, 1.0529e-4, 2.5985e-5, 6.4751e-6}, 2e-4});
  expect_known(r, {"strang_weak2", "error", "energy", {4.0813e-4, 1.022e-4, 2.556e-5, 6.389e-6}, 3e-4});
  expect_known(r, {"strang_weak2", "error", "pi3", {9.2392e-4, 2.3347e-4}, 1e-4});
  expect_known(r, {"strang_extrapolated", "error", "pi1", {4.4446e-6, 2.7219e-7, 1.6620e-8, 1.0008e-9}, 4e-3});
  for (const auto& v : r.verdicts) EXPECT_EQ(v.kind, report::verdict_kind::holds) << v.scheme << ": " << v.reason;
  EXPECT_EQ(r.verdicts.size(), 9u);  // four schemes at the horizon and at all times, one combination
}

// dt^2, dt^3 and dt^4 gone: between n = 4, 8, 16 errors fall by more than 2^5, then rounding is reached.
TEST(Weak, FourRunsTogetherFallFasterThanTheFifthPower) {
  const auto r = quick_results(load_scene("paper"), {"weak"}, {"strang_two_turns"});
  for (const char* observable : {"energy", "pi2", "pi1^2", "pi2^2", "pi3^2", "exp(pi3)"}) {
    const auto at = [&](int steps) { return value_at(r, "strang_extrapolated5", "error", observable, steps); };
    EXPECT_GT(at(4), 32 * at(8)) << observable;
    EXPECT_GT(at(8), 32 * at(16)) << observable;
    EXPECT_LT(at(16), 2e-12) << observable;
  }
  const auto steps = [&](std::string_view scheme, std::string_view accuracy) {
    for (const auto& m : r.measurements)
      if (m.scheme == scheme && m.quantity == "steps for an error" && m.observable == accuracy) return *m.value;
    return std::nan("");
  };
  EXPECT_GT(steps("strang_two_turns", "1e-08"), 20 * steps("strang_extrapolated", "1e-08"));
  EXPECT_GT(steps("strang_extrapolated", "1e-08"), steps("strang_extrapolated5", "1e-08"));
}

TEST(Gibbs, BiasIsTheKnownOne) {
  const auto r = quick_results(load_scene("paper"), {"gibbs"},
                               {"lie_euler", "implicit_midpoint", "strang_two_turns", "strang_weak2"});
  expect_known(r, {"lie_euler", "bias", "energy", {1.059e-2, 5.411e-3, 2.728e-3, 1.369e-3}, 1e-3});
  expect_known(r, {"implicit_midpoint", "bias", "energy", {1.25e-3, 7.01e-4, 3.73e-4, 1.93e-4}, 4e-3});
  expect_known(r, {"strang_two_turns", "bias", "energy", {3.2265e-4, 8.0616e-5, 2.0149e-5, 5.0368e-6}, 1e-4});
  expect_known(r, {"strang_weak2", "bias", "energy", {3.215e-4, 8.038e-5, 2.009e-5, 5.023e-6}, 2.5e-4});
  int orders = 0;
  for (const auto& v : r.verdicts) orders += v.claim == "order of the stationary bias" && *v.estimate > 0.9;
  EXPECT_EQ(orders, 4);
}

TEST(Transfer, ThreadsChangeNothing) {
  const auto text = [](int threads) {
    auto r = quick_results(load_scene("paper"), {"weak"}, {"lie_euler", "heun"}, threads);
    r.provenance = {};
    return report::to_json(r);
  };
  EXPECT_EQ(text(1), text(3));
}

}  // namespace
}  // namespace polhode
