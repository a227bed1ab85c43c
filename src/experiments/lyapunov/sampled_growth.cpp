// SPDX-License-Identifier: Apache-2.0
#include "experiments/lyapunov/sampled_growth.hpp"

#include <algorithm>

#include "experiments/common/judge.hpp"

namespace polhode {

void sampled_growth::sample(const sampling_plan& plan, double tight) {
  const int paths = blocks_of(plan.most) * block_lanes;
  for (const auto& scheme : schemes_) {
    found_.emplace_back(paths);
    kernels_.push_back(scheme.tangent(run_.dt));
  }
  log_.emplace(*context_.subject.model, blocks_of(plan.most));
  sizes_ = sample_until_tight(
      context_, plan, static_cast<int>(schemes_.size()),
      [&](int block, std::span<const int> open) { run(block, open); },
      [&](int scheme, int so_far) { return is_tight(static_cast<std::size_t>(scheme), so_far, tight); });
}

interval_estimate sampled_growth::mean(std::size_t scheme, Eigen::VectorXd growth::*what, int paths) const {
  const auto all = without_noise(scheme, what, paths);
  return mean_interval({all.data(), static_cast<std::size_t>(all.size())});
}

interval_estimate sampled_growth::raw_mean(std::size_t scheme, Eigen::VectorXd growth::*what, int paths) const {
  const Eigen::VectorXd all = (found_[scheme].*what).head(paths);
  return mean_interval({all.data(), static_cast<std::size_t>(all.size())});
}

control_means sampled_growth::controls(std::size_t scheme, int paths) const {
  return means_of_controls(found_[scheme].control.topRows(paths));
}

control_means sampled_growth::controls(std::size_t scheme, int paths, const discretisation_growth& own,
                                       double slack) const {
  Eigen::MatrixXd all(paths, growth::controls + 2);
  all.leftCols(growth::controls) = found_[scheme].control.topRows(paths);
  Eigen::Index i = 0;
  for (const auto what : {&growth::length, &growth::area}) {
    const Eigen::VectorXd over = without_noise(scheme, what, paths).array() - own.value[i];
    all.col(growth::controls + i++) = over.array() - std::clamp(over.mean(), -slack, slack);
  }
  return means_of_controls(all);
}

Eigen::VectorXd sampled_growth::without_noise(std::size_t scheme, Eigen::VectorXd growth::*what, int paths) const {
  const auto& g = found_[scheme];
  return controlled((g.*what).head(paths), g.control.topRows(paths));
}

void sampled_growth::run(int block, std::span<const int> open) {
  std::vector<const tangent_kernel*> kernels;
  std::vector<growth*> out;
  bool areas = false;
  for (const int k : open) {
    const auto i = static_cast<std::size_t>(k);
    kernels.push_back(kernels_[i].get());
    out.push_back(&found_[i]);
    areas = areas || schemes_[i].needs_areas;
  }
  run_tangents(context_, run_, block, kernels, areas, out, &*log_);
}

bool sampled_growth::is_tight(std::size_t scheme, int paths, double tight) const {
  for (const auto what : {&growth::length, &growth::area})
    if (!(half_width(mean(scheme, what, paths)) <= tight)) return false;
  return true;
}

}  // namespace polhode
