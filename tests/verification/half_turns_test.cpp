// SPDX-License-Identifier: Apache-2.0
// Operators by the half turns of the body: the same as without them, and only where the step commutes with them.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/kernel_decorator.hpp"
#include "support/verdicts.hpp"
#include "transfer/frame_transfer.hpp"
#include "transfer/points/half_turns.hpp"
#include "transfer/transfer.hpp"

namespace polhode {
namespace {

using test::scheme_of;

/// The kernel with something of its own after each common step.
class changed final : public test::kernel_decorator {
 public:
  using kernel_decorator::advance;
  using change = std::function<void(std::span<double>)>;
  changed(std::unique_ptr<kernel> k, change c) : kernel_decorator(std::move(k)), change_(std::move(c)) {}
  void advance(std::span<double> states, const shared_steps& v, std::int64_t first, std::int64_t steps,
               piece p) const override {
    kernel_decorator::advance(states, v, first, steps, p);
    change_(states);
  }

 private:
  change change_;
};

scheme_entry with_change(scheme_entry e, const changed::change& c) {
  e.make = [inner = e.make, c](double dt) { return std::make_unique<changed>(inner(dt), c); };
  return e;
}

void nothing(std::span<double>) {}

/// Towards axis 1, by less than anything else would show.
void drawn_to_axis_1(std::span<double> states) {
  for (std::size_t lane = 0; lane < block_lanes; ++lane) states[lane] += 1e-10;
}

TEST(HalfTurns, SplitTheOperatorOfEveryScheme) {
  const auto s = bind_scene(load_scene("paper"));
  ASSERT_FALSE(s.schemes.empty());
  for (const auto& e : s.schemes) {
    const auto rule = e.info.casimir.exact ? transfer_rule{{8, 1, 0}, {3, 2}} : transfer_rule{{6, 4, 4}, {3, 2}};
    const auto op = make_transfer(s, e, 0.1, 4, rule);
    const auto whole = make_transfer(s, with_change(e, drawn_to_axis_1), 0.1, 4, rule);
    ASSERT_EQ(op.blocks.size(), 4u) << e.info.name;
    ASSERT_EQ(whole.blocks.size(), 1u) << e.info.name;
    EXPECT_EQ(make_transfer(s, with_change(e, nothing), 0.1, 4, rule).blocks.size(), 4u) << e.info.name;
    EXPECT_LT((op.matrix - whole.matrix).cwiseAbs().maxCoeff(), 1e-7) << e.info.name;
    const Eigen::Vector3d start(s.scene.momentum.data());
    EXPECT_LT((op.law_after(start, 4) - whole.law_after(start, 4)).norm(), 1e-7) << e.info.name;
    if (!e.info.casimir.exact) continue;
    EXPECT_LT((op.stationary_law() - whole.stationary_law()).norm(), 1e-6) << e.info.name;
  }
}

TEST(HalfTurns, AreNotTakenForGrantedUnderOtherNoise) {
  auto scene = load_scene("paper");
  scene.vectors("sigma") = {{0.3, 0.1, 0}, {-0.2, 0.4, 0.1}, {0, 0.3, 0.2}};
  const auto s = bind_scene(scene);
  EXPECT_EQ(make_transfer(s, scheme_of(s, "strang"), 0.1, 1, {{6, 1, 0}, {3, 2}}).blocks.size(), 1u);
  const auto one = bind_scene(load_scene("single"));
  EXPECT_EQ(make_transfer(one, scheme_of(one, "magnus"), 0.1, 1, {{6, 1, 0}, {3, 2}}).blocks.size(), 1u);
}

// Every scheme on the sphere, and noise of different strength along the axes: all functions against the invariant ones.
TEST(HalfTurns, InvariantFunctionsHaveTheExponents) {
  for (const char* name : {"paper", "anisotropic"}) {
    const auto s = bind_scene(load_scene(name));
    int compared = 0;
    for (const auto& e : s.schemes) {
      if (!e.info.casimir.exact) continue;
      const transfer_rule rule{{5, 1, 0}, {3, 2}};
      const Eigen::Vector2d whole = make_frame_transfer(s, e, 0.1, rule).exponents();
      EXPECT_LT((discretisation_exponents(s, e, 0.1, rule) - whole).norm(), 1e-12) << name << ' ' << e.info.name;
      ++compared;
    }
    EXPECT_GT(compared, 0) << name;
  }
}

TEST(HalfTurns, InvariantFunctionsAreAQuarterAndOrthonormal) {
  for (const int degree : {3, 6}) {
    const frame_basis all(degree), invariant(degree, frame_basis::functions::invariant);
    EXPECT_LT(invariant.size(), 0.35 * all.size());
    EXPECT_EQ(4 * invariant.points().rows(), all.points().rows());
    // The coefficients of each function, from its own values.
    Eigen::MatrixXd found = Eigen::MatrixXd::Zero(invariant.size(), invariant.size());
    frame_means means(invariant, invariant.turns());
    const auto& x = invariant.points();
    const double one = 1;
    for (int first = 0; first < x.rows(); first += block_lanes) {
      const int lanes = std::min(block_lanes, static_cast<int>(x.rows()) - first);
      std::vector<double> states(3 * block_lanes), tangents(6 * block_lanes);
      for (int lane = 0; lane < block_lanes; ++lane)
        for (int i = 0; i < 3; ++i) {
          const int row = first + std::min(lane, lanes - 1);
          const auto at = static_cast<std::size_t>(i * block_lanes + lane);
          states[at] = x(row, i);
          tangents[at] = invariant.first_tangents()(row, i);
          tangents[at + 3 * block_lanes] = invariant.second_tangents()(row, i);
        }
      means.clear();
      means.add(lanes, {&one, 1}, states.data(), tangents.data());
      std::vector<Eigen::MatrixXd> values;
      for (int angle = 0; angle < invariant.angles(); ++angle) values.push_back(means.functions(angle, lanes));
      invariant.add_coefficients(first, values, found);
    }
    EXPECT_LT((found - Eigen::MatrixXd::Identity(found.rows(), found.cols())).cwiseAbs().maxCoeff(), 1e-12);
  }
}

}  // namespace
}  // namespace polhode
