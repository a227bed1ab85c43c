// SPDX-License-Identifier: Apache-2.0
// The operator of a step on frames, under noise alone: known by Peter and Weyl, for every instruction set.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "platform/isa.hpp"
#include "run/run_experiment.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "transfer/frame_transfer.hpp"

namespace polhode {
namespace {

// A rotation by a normal vector is a class function: E[D^l] = E[sin((2l+1) f/2) / sin(f/2)] / (2l+1) times the
// identity, f the angle (Peter and Weyl).
std::vector<double> means_over_rotations(double sigma, double dt, int degree) {
  std::vector<double> out;
  for (int l = 0; l <= degree; ++l) {
    double sum = 0;  // 1 + 2 sum E[cos k f], f^2 = sigma^2 dt chi^2_3
    for (int k = -l; k <= l; ++k) {
      const double variance = k * k * sigma * sigma * dt;
      sum += (1 - variance) * std::exp(-variance / 2);
    }
    out.push_back(sum / (2 * l + 1));
  }
  return out;
}

TEST(FrameTransfer, OfNoiseAloneIsAMultipleOfTheIdentityInEachDegree) {
  constexpr double sigma = 0.5, dt = 0.25;
  constexpr int degree = 6;
  auto scene = load_scene("undamped");
  scene.vector("inertia") = {1e13, 1e13, 1e13};
  ASSERT_EQ(scene.vectors("sigma")[0][0], sigma);
  const auto expected = means_over_rotations(sigma, dt, degree);
  for (const isa level : usable_isas()) {
    choose_isa(level);
    const auto s = restricted(bind_scene(scene), {"lie_euler"});
    const auto op = make_frame_transfer(s, s.schemes[0], dt, {{degree, 1, 0}, {13, 2}});
    Eigen::MatrixXd rest = op.matrix;
    Eigen::Index i = 0;
    for (int n = 0; n <= degree; n += 2)
      for (int m = n == 0 ? 0 : -degree; m <= degree; ++m)
        for (int l = std::max(std::abs(m), n); l <= degree; ++l)
          for (int part = 0; part < (m == 0 && n == 0 ? 1 : 2); ++part, ++i)
            rest(i, i) -= expected[static_cast<std::size_t>(l)];
    ASSERT_EQ(i, rest.rows());
    EXPECT_LT(rest.cwiseAbs().maxCoeff(), 1e-11) << name_of(level);
    EXPECT_LT(op.exponents().cwiseAbs().maxCoeff(), 1e-10) << name_of(level);
  }
  choose_isa(usable_isas().back());
}

}  // namespace
}  // namespace polhode
