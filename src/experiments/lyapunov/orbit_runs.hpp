// SPDX-License-Identifier: Apache-2.0
// Schemes with their tangents through the paths of the equation.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "experiments/lyapunov/orbit_reference.hpp"

namespace polhode {

/// A scheme with so many tangents.
using flow_of_scheme = std::function<std::unique_ptr<tangent_flow>(const scheme_entry&)>;

/// All schemes through the same noise as the equation, each as far as its own intervals ask: the first block over the
/// first third of the time in which the equation was observed, over all of it, then more blocks.
class scheme_paths {
 public:
  /// of_equation: at the same dt; it says how long paths are. Of a scheme the first `vectors` exponents.
  scheme_paths(const context&, const orbit_frame&, const std::vector<scheme_entry>&, const observed_rates& of_equation,
               int vectors, const flow_of_scheme&);

  /// tight: the half-width at which paths are enough; of lambda_1 also twice that of the equation, for its sign.
  void sample(double tight);

  /// [path][k], of those that were enough: its exponents; and less those of the equation on the same path and time.
  Eigen::MatrixXd rates(std::size_t scheme) const;
  Eigen::MatrixXd differences(std::size_t scheme) const;
  /// [component][lane] of the first block, where its paths end, and after how many steps that is.
  std::span<const double> last_states(std::size_t scheme) const;
  std::int64_t steps(std::size_t scheme) const;
  /// "128 of 256 planned paths were enough, over a third of the planned time"; or that paths were lost.
  std::string text(std::size_t scheme) const;

 private:
  struct sampled {
    std::unique_ptr<tangent_flow> flow;
    bool areas;
    Eigen::MatrixXd rates;
    std::vector<std::optional<orbit_block>> blocks;
    sample_size size;
    bool whole;  ///< all of the time
  };

  void sample_one(sampled&, const context&, double tight) const;
  void advance(sampled&, int block, std::int64_t first_chunk, std::int64_t last_chunk) const;
  Eigen::MatrixXd differences(const sampled&, int paths) const;
  bool is_tight(const Eigen::MatrixXd& differences, double tight) const;

  const context& context_;
  const orbit_frame& frame_;
  const observed_rates& of_equation_;
  int vectors_;
  std::vector<sampled> schemes_;
};

/// Growth of Liouville's volume less the mean divergence, [path], of one block of a scheme: 2 e(dt/2) - e(dt), e(dt)
/// taken over the same time at both steps, so that an error of order one in dt is gone. Over as much time as a
/// half-width of `tight` asks for, up to a limit.
Eigen::VectorXd volume_defects(const context&, const orbit_frame&, const scheme_entry&, double tight);

}  // namespace polhode
