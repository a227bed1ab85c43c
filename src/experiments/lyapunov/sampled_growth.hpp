// SPDX-License-Identifier: Apache-2.0
// Growth of lengths and areas along the paths of schemes, sampled until the intervals are tight.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "experiments/common/sequential.hpp"
#include "experiments/lyapunov/tangent_runs.hpp"
#include "statistics/control_variates.hpp"
#include "statistics/sample.hpp"

namespace polhode {

/// lambda_1 and lambda_1 + lambda_2 of a scheme at a step, known without sampling (frame_transfer.hpp).
struct discretisation_growth {
  Eigen::Vector2d value, uncertainty;
};

/// Of schemes that keep the sphere, all through one noise. scheme: its place among them.
class sampled_growth {
 public:
  sampled_growth(const context& c, const std::vector<scheme_entry>& schemes, const run_length& run)
      : context_(c), schemes_(schemes), run_(run) {}

  /// tight: the half-width at which a scheme's paths are enough.
  void sample(const sampling_plan&, double tight);

  const sample_size& size(std::size_t scheme) const { return sizes_[scheme]; }
  void report_noise(report::results& out) const { log_->report("lyapunov", out); }

  /// Without the noise that can be taken out.
  interval_estimate mean(std::size_t scheme, Eigen::VectorXd growth::*what, int paths) const;
  /// With the noise that the controls take out: their means are zero if the noise has its law, and only then does
  /// taking them out change nothing but the variance.
  interval_estimate raw_mean(std::size_t scheme, Eigen::VectorXd growth::*what, int paths) const;

  control_means controls(std::size_t scheme, int paths) const;
  /// With the growths less those that are known: a mean of at most `slack` is none.
  control_means controls(std::size_t scheme, int paths, const discretisation_growth&, double slack) const;

 private:
  Eigen::VectorXd without_noise(std::size_t scheme, Eigen::VectorXd growth::*what, int paths) const;
  void run(int block, std::span<const int> open);
  bool is_tight(std::size_t scheme, int paths, double tight) const;

  const context& context_;
  const std::vector<scheme_entry>& schemes_;
  run_length run_;
  std::vector<growth> found_;                             // [scheme]
  std::vector<std::unique_ptr<tangent_kernel>> kernels_;  // the same
  std::vector<sample_size> sizes_;
  std::optional<noise_log> log_;
};

}  // namespace polhode
