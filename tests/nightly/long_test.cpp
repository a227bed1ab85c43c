// SPDX-License-Identifier: Apache-2.0
// Runs too long for every push: ctest -L nightly.
#include <gtest/gtest.h>

#include <cstdio>

#include "ensemble/noise/paths.hpp"
#include "experiments/stability/stability_long.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "statistics/orders/order_fit.hpp"

namespace polhode {
namespace {

// Ten million steps: rounding grows like a random walk, and its growth law is found.
TEST(Casimir, TenMillionSteps) {
  verify_options options;
  options.experiments = {"casimir"};
  options.effort = effort::thorough;
  options.threads = 2;
  const auto r = verify(load_scene("paper"), options);
  ASSERT_FALSE(r.verdicts.empty());
  for (const auto& v : r.verdicts) EXPECT_EQ(v.kind, report::verdict_kind::holds) << v.scheme << ": " << v.reason;
  int laws = 0;
  for (const auto& f : r.fits)
    if (f.quantity == "drift_over_steps") {
      EXPECT_LT(f.order, 0.8) << f.scheme;
      ++laws;
    }
  EXPECT_GT(laws, 0);
}

// A hundred million steps of 64 paths: what is left of |Pi|'s error is a random walk of roundings, for every scheme.
TEST(Stability, HundredMillionStepsDriftLikeARandomWalk) {
  const auto s = bind_scene(load_scene("paper"));
  std::vector<const scheme_entry*> exact;
  for (const auto& e : s.schemes)
    if (e.info.casimir.exact) exact.push_back(&e);
  ASSERT_FALSE(exact.empty());
  std::vector<long_drift> found(exact.size());
  parallel_for(2, static_cast<int>(exact.size()), [&](int i) {
    const auto& e = *exact[static_cast<std::size_t>(i)];
    found[static_cast<std::size_t>(i)] =
        drift_over(s, e, 0.03125, e.info.implicit ? 1e7 : 1e8, 1, noise_generator::ars);
  });
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const auto law = fit_power_law(found[i].steps, found[i].rms);
    ASSERT_TRUE(law) << exact[i]->info.name;
    EXPECT_LT(law->order, 0.8) << exact[i]->info.name;
    EXPECT_LT(found[i].rms.back(), 1e-11) << exact[i]->info.name;
    std::printf("%s: %.2e after %.1e steps, growth %.2f\n", std::string(exact[i]->info.name).c_str(),
                found[i].rms.back(), found[i].steps.back(), law->order);
  }
}

}  // namespace
}  // namespace polhode
