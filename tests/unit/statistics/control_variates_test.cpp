// SPDX-License-Identifier: Apache-2.0
#include "statistics/control_variates.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include <polhode/noise/normal.hpp>

#include "statistics/orders/order_fit.hpp"
#include "statistics/sample.hpp"
#include "support/dense.hpp"

namespace polhode {
namespace {

/// y = 3 + 2 Y_1 - Y_2 + 0.1 noise; the third control is a copy of the first, the fourth is not there.
struct drawn {
  Eigen::VectorXd y;
  Eigen::MatrixXd controls;
  drawn(int paths, std::uint64_t seed) : y(paths), controls(paths, 4) {
    for (int i = 0; i < paths; ++i) {
      const auto z = normals<3>({seed, noise_kind::increment, static_cast<std::uint64_t>(i), 0});
      controls.row(i) << z[0], z[1], z[0], 0;
      y[i] = 3 + 2 * z[0] - z[1] + 0.1 * z[2];
    }
  }
};

interval_estimate interval_of(const Eigen::VectorXd& v) {
  return mean_interval({v.data(), static_cast<std::size_t>(v.size())});
}

TEST(ControlVariates, LeaveWhatTheyDoNotExplain) {
  const drawn d(1000, 1);
  const auto v = interval_of(controlled(d.y, d.controls));
  EXPECT_NEAR(v.value, 3, 0.02);
  EXPECT_NEAR(v.high - v.low, 2 * 1.96 * 0.1 / std::sqrt(1000.0), 1e-3);
  EXPECT_GT(interval_of(d.y).high - interval_of(d.y).low, 20 * (v.high - v.low));
}

TEST(ControlVariates, TheIntervalCoversTheMeanAsOftenAsItSays) {
  int covered = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const drawn d(100, seed);
    const auto v = interval_of(controlled(d.y, d.controls));
    covered += v.low <= 3 && 3 <= v.high;
  }
  EXPECT_GE(covered, 920);
  EXPECT_LE(covered, 975);
}

TEST(ControlVariates, APathThatIsLostIsNotHidden) {
  drawn d(100, 3);
  d.y[7] = NAN;
  EXPECT_FALSE(std::isfinite(controlled(d.y, d.controls).mean()));
}

// Student's t of a column as a normal deviate: of 1, 2, 3, 6 it is 3 over the root of 14 / 3 / 4.
TEST(ControlVariates, MeansAreHeldAgainstTheirErrors) {
  Eigen::MatrixXd y = Eigen::MatrixXd::Zero(4, 3);
  y.col(0) << -1, -2, -3, -6;
  y.col(2) << 1, -1, 2, -1;
  const double tail = cdf(complement(boost::math::students_t(3), 3 / std::sqrt(14 / 12.0)));
  const auto found = means_of_controls(y);
  EXPECT_EQ(found.count, 2);
  EXPECT_NEAR(found.largest, -quantile(complement(boost::math::normal(), tail)), 1e-12);
  y(1, 1) = NAN;
  EXPECT_FALSE(std::isfinite(means_of_controls(y).largest));
}

// Whatever the signs of the others.
TEST(OrderFit, LevelsThatAreNotClearOfZeroLeaveTheFit) {
  const std::vector<double> dt{1, 0.5, 0.25, 0.125, 0.0625};
  squared_errors e{400, 5, std::vector<double>(2000)};
  for (int path = 0; path < e.paths; ++path)
    for (int l = 0; l < e.levels; ++l)
      e.at(path, l) = (l < 4 ? (l % 2 ? 1 : -1) * dt[static_cast<std::size_t>(l)] : 0) + 0.05 * (path % 2 ? 1 : -1);
  const auto fit = fit_order_of_clear_means(dt, e, 5, 1);
  ASSERT_TRUE(fit);
  EXPECT_NEAR(fit->order, 1, 1e-9);
  EXPECT_NEAR(fit->prefactor, 1, 1e-9);
  EXPECT_FALSE(fit->used[4]);
}

// Of nine paths four and five: the least squares of either half, by a QR decomposition, are taken from the other.
TEST(ControlVariates, CoefficientsOfOneHalfComeFromTheOther) {
  constexpr int paths = 9, half = 4;
  const drawn d(paths, 4);
  const Eigen::MatrixXd controls = d.controls.leftCols(2);
  const auto fitted = [&](int from, int count) -> Eigen::VectorXd {
    Eigen::MatrixXd design(count, 3);
    design << controls.middleRows(from, count), Eigen::VectorXd::Ones(count);
    return test::least_squares_of(design, d.y.segment(from, count)).head(2);
  };
  const Eigen::VectorXd b = fitted(half, paths - half), c = fitted(0, half), found = controlled(d.y, controls);
  for (int i = 0; i < paths; ++i) EXPECT_NEAR(found[i], d.y[i] - controls.row(i).dot(i < half ? b : c), 1e-11) << i;
}

TEST(ControlVariates, OfMeansThatAreEquallyLargeTheFirstIsSaid) {
  Eigen::MatrixXd y(5, 2);
  y.col(0) << -1, -2, 0.5, -4, -3;
  y.col(1) = -y.col(0);
  EXPECT_LT(means_of_controls(y).largest, 0);
  y = -y;
  EXPECT_GT(means_of_controls(y).largest, 0);
}

}  // namespace
}  // namespace polhode
