// SPDX-License-Identifier: Apache-2.0
// The exponents of the schemes without sampling: their order, defects, and what sampled paths do.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/common/levels.hpp"
#include "experiments/lyapunov/discretisation_exponents.hpp"
#include "experiments/lyapunov/tangent_runs.hpp"
#include "run/run_experiment.hpp"
#include "transfer/frame_transfer.hpp"
#include "verification/lyapunov_schemes.hpp"

namespace polhode {
namespace {

using namespace test;
using report::verdict_kind;

report::results own(const subject& s, int threads = 2) {
  const context c{s, effort::quick, threads};
  report::results out;
  report_discretisation_exponents(c, s.schemes, lyapunov(*s.sphere(), 1e-10), out);
  return out;
}

constexpr auto order_claim = "order of the exponents";

TEST(OwnExponents, ConvergeToThoseOfTheEquation) {
  const auto r = own(with_schemes(load_scene("paper"), {"implicit_midpoint", "strang_weak2"}));
  ASSERT_EQ(r.verdicts.size(), 2u);
  for (const auto& v : r.verdicts) EXPECT_EQ(v.kind, verdict_kind::holds) << v.scheme << ": " << v.reason;
  EXPECT_NEAR(*r.verdicts.back().estimate, 2, 0.02);
}

TEST(OwnExponents, AWrongTangentIsRefuted) {
  const auto r = own(with_mutant<generator_frozen_in_the_tangent>(load_scene("paper")));
  EXPECT_EQ(verdict_kind_of(r, "generator_frozen_in_the_tangent", order_claim), verdict_kind::refuted);
}
TEST(OwnExponents, TheWrongEquationIsRefuted) {
  const auto r = own(with_mutant<ito_drift_added>(paper_with_unequal_noise()));
  EXPECT_EQ(verdict_kind_of(r, "ito_drift_added", order_claim), verdict_kind::refuted);
}

TEST(OwnExponents, ThreadsAndCompanyChangeNothing) {
  const auto scene = load_scene("anisotropic");
  expect_the_same(own(with_schemes(scene, {"cayley_heun"}), 1), own(with_schemes(scene, {"cayley_heun", "magnus"}), 3),
                  "cayley_heun");
}

/// Mean and standard error of what paths of a scheme stretch.
struct sampled_pair {
  double mean, error;
};
sampled_pair mean_of(const Eigen::VectorXd& x) {
  const double mean = x.mean(), n = static_cast<double>(x.size());
  return {mean, std::sqrt((x.array() - mean).square().sum() / (n * (n - 1)))};
}

// Schemes of every kind at a step where their exponents are far from those of the equation; noise of any kind.
TEST(OwnExponents, AreWhatSampledPathsDo) {
  auto scene = load_scene("paper");
  scene.vectors("sigma") = {{0.3, 0.1, 0}, {-0.2, 0.4, 0.1}, {0, 0.3, 0.2}};
  const auto s = with_schemes(scene, {"lie_euler", "implicit_midpoint", "strang", "magnus", "heun_projected"});
  ASSERT_EQ(s.schemes.size(), 5u);
  const context c{s, effort::quick, 1};
  constexpr double dt = 0.25;
  constexpr int blocks = 24;
  for (const auto& scheme : s.schemes) {
    const auto kernel = scheme.tangent(dt);
    growth found(blocks * block_lanes);
    growth* const out[]{&found};
    const tangent_kernel* const kernels[]{kernel.get()};
    for (int block = 0; block < blocks; ++block)
      run_tangents(c, run_length_of(dt, 30, 400), block, kernels, scheme.needs_areas, out);
    const auto exponents = make_frame_transfer(s, scheme, dt, {{10, 1, 0}, {5, 2}}).exponents();
    const auto length = mean_of(found.length), area = mean_of(found.area);
    EXPECT_LT(length.error, 6e-4);
    EXPECT_NEAR(exponents[0], length.mean, 4 * length.error) << scheme.info.name;
    EXPECT_NEAR(exponents[1], area.mean, 4 * area.error) << scheme.info.name;
  }
}

}  // namespace
}  // namespace polhode
