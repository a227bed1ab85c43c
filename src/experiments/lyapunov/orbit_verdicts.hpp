// SPDX-License-Identifier: Apache-2.0
// What means over paths say of exponents.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "reports/model/results.hpp"
#include "statistics/sample.hpp"

namespace polhode {

interval_estimate mean_of(const Eigen::VectorXd& values);

/// Means of the columns of [path][k], which should vanish, judged together: the intervals cover all means at once with
/// 95 % (Bonferroni). Refuted if one is; the worst is told by its name.
report::verdict judge_all(const Eigen::MatrixXd& values, double margin,
                          const std::function<std::string(Eigen::Index)>& name);

/// Whether lambda_1 has a sign: chaos above zero; inconclusive where it straddles that.
report::verdict judge_sign(const interval_estimate&);

/// Whether lambda_1 of a scheme has the sign of that of the equation; inconclusive where one of them straddles zero.
report::verdict judge_sign(const interval_estimate& of_equation, const interval_estimate& of_scheme);

/// The mean of the equation over all its paths, and the difference on those that a scheme has as well.
interval_estimate corrected(const interval_estimate& of_equation, const interval_estimate& difference);

/// Kaplan and Yorke's dimension j + (lambda_1 + ... + lambda_j) / |lambda_{j+1}|, j the most whose sum is not negative;
/// 0, a point, where lambda_1 <= 0. Of exponents in decreasing order.
double kaplan_yorke(std::span<const double> exponents);

/// That of the means of [path][k], sorted, with the interval of resampled paths.
interval_estimate dimension_of(const Eigen::MatrixXd& rates, std::uint64_t seed);

}  // namespace polhode
