// SPDX-License-Identifier: Apache-2.0
#include "experiments/weak/path_controls.hpp"

#include "statistics/control_variates.hpp"
#include "statistics/resampled_means.hpp"

namespace polhode {
namespace {

constexpr Eigen::Index most_linear = 48, most_quadratic = 21;  // columns, a regression on few hundred paths

}  // namespace

path_controls::path_controls(const noise_layout& layout, int parts, double horizon, int paths)
    : channels_(layout.active),
      parts_(layout.active * parts <= most_linear ? parts : 1),
      stride_(layout.channels),
      horizon_(horizon),
      increments_(Eigen::MatrixXd::Zero(paths, parts_ * channels_)) {}

void path_controls::keep(int first_path, int part, const increment_view& view) {
  const Eigen::Map<const values_of_paths> dw(view.dw.data(), stride_, block_lanes);
  increments_.block(first_path, parts_ > 1 ? part * channels_ : 0, block_lanes, channels_) +=
      dw.topRows(channels_).transpose();
}

Eigen::MatrixXd path_controls::of_paths(Eigen::Index paths) const {
  const auto linear = increments_.topRows(paths);
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(paths, channels_);
  for (Eigen::Index part = 0; part < parts_; ++part) sum += linear.middleCols(part * channels_, channels_);
  const Eigen::Index products = channels_ * (channels_ + 1) / 2;
  Eigen::MatrixXd out(paths, linear.cols() + (products <= most_quadratic ? products : 0));
  out.leftCols(linear.cols()) = linear;
  Eigen::Index next = linear.cols();
  if (products > most_quadratic) return out;
  for (Eigen::Index i = 0; i < channels_; ++i)
    for (Eigen::Index j = i; j < channels_; ++j)
      out.col(next++) = sum.col(i).array() * sum.col(j).array() - (i == j ? horizon_ : 0);
  return out;
}

std::vector<squared_errors> path_controls::taken_out_of(const std::vector<squared_errors>& values) const {
  const Eigen::Index paths = values.front().paths, levels = values.front().levels;
  Eigen::MatrixXd all(paths, levels * static_cast<Eigen::Index>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i)
    all.middleCols(static_cast<Eigen::Index>(i) * levels, levels) = matrix_of(values[i]);
  all = all_controlled(all, of_paths(paths));
  auto out = values;
  for (std::size_t i = 0; i < values.size(); ++i)
    Eigen::Map<values_of_paths>(out[i].values.data(), paths, levels) =
        all.middleCols(static_cast<Eigen::Index>(i) * levels, levels);
  return out;
}

}  // namespace polhode
