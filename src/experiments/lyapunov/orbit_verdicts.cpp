// SPDX-License-Identifier: Apache-2.0
#include "experiments/lyapunov/orbit_verdicts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "experiments/common/judge.hpp"
#include "statistics/distributions.hpp"
#include "statistics/resample.hpp"
#include "statistics/resampled_means.hpp"

namespace polhode {

interval_estimate mean_of(const Eigen::VectorXd& values) {
  return mean_interval({values.data(), static_cast<std::size_t>(values.size())});
}

report::verdict judge_all(const Eigen::MatrixXd& values, double margin,
                          const std::function<std::string(Eigen::Index)>& name) {
  const double wider = normal_deviate(0.025 / static_cast<double>(values.cols())) / normal_deviate(0.025);
  const auto rank = [](report::verdict_kind kind) {
    return kind == report::verdict_kind::refuted ? 2 : kind == report::verdict_kind::inconclusive ? 1 : 0;
  };
  report::verdict v{.expected = 0.0, .kind = report::verdict_kind::holds};
  for (Eigen::Index k = 0; k < values.cols(); ++k) {
    const auto found = mean_of(values.col(k));
    if (!std::isfinite(found.value)) return {.expected = 0.0, .reason = "not finite: a step of the scheme fails"};
    const double half = wider * half_width(found), low = found.value - half, high = found.value + half;
    const auto kind = judge(0, low, high, margin);
    const bool further = !v.low || std::max(-low, high) > std::max(-*v.low, *v.high);
    if (rank(kind) < rank(v.kind) || (kind == v.kind && !further)) continue;
    v.kind = kind;
    v.estimate = found.value;
    v.low = low;
    v.high = high;
    v.reason = fmt::format("{} is off by {:.5f} [{:.5f}, {:.5f}], at most {:.2g} is allowed", name(k), found.value, low,
                           high, margin);
  }
  return v;
}

report::verdict judge_sign(const interval_estimate& found) {
  if (!std::isfinite(found.value)) return {.reason = "not finite: a step of the scheme fails"};
  report::verdict v{.estimate = found.value, .low = found.low, .high = found.high};
  const auto text = fmt::format("lambda_1 = {:.4f} [{:.4f}, {:.4f}]", found.value, found.low, found.high);
  if (found.low > 0 || found.high < 0) v.kind = report::verdict_kind::holds;
  v.reason = (found.low > 0    ? "one noise spreads neighbours, chaos: "
              : found.high < 0 ? "one noise collects neighbours: "
                               : "neither spreading nor collecting is certain: ") +
             text;
  return v;
}

report::verdict judge_sign(const interval_estimate& of_equation, const interval_estimate& of_scheme) {
  auto v = judge_sign(of_scheme);
  v.expected = of_equation.value;
  if (judge_sign(of_equation).kind != report::verdict_kind::holds) v.kind = report::verdict_kind::inconclusive;
  if (v.kind == report::verdict_kind::holds && (of_equation.low > 0) != (of_scheme.low > 0))
    v.kind = report::verdict_kind::refuted;
  v.reason += fmt::format(", of the equation [{:.4f}, {:.4f}]", of_equation.low, of_equation.high);
  return v;
}

interval_estimate corrected(const interval_estimate& of_equation, const interval_estimate& difference) {
  const double value = of_equation.value + difference.value,
               half = std::hypot(half_width(of_equation), half_width(difference));
  return {value, value - half, value + half};
}

double kaplan_yorke(std::span<const double> exponents) {
  double sum = 0;
  std::size_t j = 0;
  for (; j < exponents.size() && sum + exponents[j] >= 0; ++j) sum += exponents[j];
  if (exponents.empty() || exponents[0] <= 0) return 0;
  return static_cast<double>(j) + (j < exponents.size() ? sum / std::fabs(exponents[j]) : 0);
}

interval_estimate dimension_of(const Eigen::MatrixXd& rates, std::uint64_t seed) {
  const auto dimension = [](Eigen::RowVectorXd means) {
    std::ranges::sort(means, std::greater());
    return kaplan_yorke({means.data(), static_cast<std::size_t>(means.size())});
  };
  const Eigen::MatrixXd resampled = resampled_means(rates, seed);
  std::vector<double> found;
  for (Eigen::Index i = 0; i < resampled.rows(); ++i) found.push_back(dimension(resampled.row(i)));
  const auto [low, high] = bootstrap_interval(found, 0.95, static_cast<int>(rates.rows()));
  return {dimension(rates.colwise().mean()), low, high};
}

}  // namespace polhode
