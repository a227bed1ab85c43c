// SPDX-License-Identifier: Apache-2.0
#include "experiments/attractor/path_averages.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "ensemble/noise/paths.hpp"
#include "statistics/distributions.hpp"
#include "statistics/resample.hpp"

namespace polhode {
namespace {

constexpr int row = block_lanes;  // noise paths whose averages over 2, 4, … 64 are one sample of the slope

/// Columns averaged in neighbouring pairs.
Eigen::MatrixXd halved(const Eigen::MatrixXd& m) {
  Eigen::MatrixXd out(m.rows(), m.cols() / 2);
  for (Eigen::Index i = 0; i < out.cols(); ++i) out.col(i) = 0.5 * (m.col(2 * i) + m.col(2 * i + 1));
  return out;
}

/// The means over the looks at the same paths, `of_look` values a look and block.
Eigen::ArrayXd over_looks(const Eigen::ArrayXd& values, int looks, int of_look) {
  Eigen::ArrayXd out = Eigen::ArrayXd::Zero(values.size() / looks);
  for (Eigen::Index i = 0; i < values.size(); ++i)
    out[i / (looks * of_look) * of_look + i % of_look] += values[i] / looks;
  return out;
}

/// Half of the 95 % interval of the mean; NaN of too few.
double half_width_of_mean(const Eigen::ArrayXd& values) {
  const auto n = static_cast<double>(values.size());
  if (n < 4) return NAN;
  return student_t_quantile(0.975, n - 1) * std::sqrt((values - values.mean()).square().mean() / (n - 1));
}

}  // namespace

grand_mean mean_of(const Eigen::MatrixXd& means, std::uint64_t seed) {
  Eigen::MatrixXd rows = means;
  for (int n = 1; n < row; n *= 2) rows = halved(rows);
  grand_mean out{rows.rowwise().mean(), 0};
  std::vector<double> off;
  for (int r = 0; r < bootstrap_replicates; ++r) {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(rows.rows());
    for (const int i : resample(seed, r, static_cast<int>(rows.cols()))) sum += rows.col(i);
    off.push_back((sum / static_cast<double>(rows.cols()) - out.value).norm());
  }
  out.error = central_interval(off, 0.9).second;
  return out;
}

distances distances_of(const Eigen::MatrixXd& means, int looks, double bias) {
  const int count = static_cast<int>(means.cols()) / row, levels = std::bit_width(static_cast<unsigned>(row));
  distances out;
  out.rows = {count, levels, std::vector<double>(static_cast<std::size_t>(count * levels))};
  int level = 0;
  for (Eigen::MatrixXd at = means;; at = halved(at), ++level) {
    const Eigen::ArrayXd square = at.colwise().squaredNorm().transpose();
    const auto n = square.size();
    out.paths.push_back(std::exp2(level));
    out.value.push_back(std::sqrt(square.mean()));
    const double error =
        level < levels ? half_width_of_mean(over_looks(square, looks, row >> level)) : half_width_of_mean(square);
    const bool known = std::isfinite(error);
    out.low.push_back(known ? std::optional(std::sqrt(std::max(0.0, square.mean() - error))) : std::nullopt);
    out.high.push_back(known ? std::optional(std::sqrt(square.mean() + error)) : std::nullopt);
    if (level < levels)
      for (int i = 0; i < count; ++i)
        out.rows.at(i, level) = square.segment(i * n / count, n / count).mean() - bias * bias;
    if (n == 1) return out;
  }
}

std::optional<order_fit> slope_over_paths(const distances& d, std::uint64_t seed) {
  std::vector<double> inverse;
  for (int i = 0; i < d.rows.levels; ++i) inverse.push_back(1 / d.paths[static_cast<std::size_t>(i)]);
  auto fit = fit_order(inverse, d.rows, 0, seed);
  if (!fit) return fit;
  fit->order = -fit->order;
  fit->low = -std::exchange(fit->high, -fit->low);
  fit->used.resize(d.paths.size());
  fit->rule += "; squares less the exact bias of the scheme's own law";
  return fit;
}

}  // namespace polhode
