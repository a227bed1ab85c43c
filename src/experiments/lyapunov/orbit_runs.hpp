// Schemes with their tangents through the paths of the equation.
#pragma once

#include <functional>

#include "experiments/lyapunov/orbit_reference.hpp"

namespace polhode {

/// A scheme with so many tangents.
using flow_of_scheme = std::function<std::unique_ptr<tangent_flow>(const scheme_entry&)>;

/// All schemes through the same blocks of noise as the equation, each as far as its own intervals ask.
class scheme_paths {
 public:
  /// of_equation: at the same dt; it says how long paths are. Of a scheme the first `vectors` exponents.
  scheme_paths(const context&, const orbit_frame&, const std::vector<scheme_entry>&, const observed_rates& of_equation,
               int vectors, const flow_of_scheme&);

  /// tight: the half-width at which paths are enough.
  void sample(double tight);

  const sample_size& size(std::size_t scheme) const { return sizes_[scheme]; }
  /// [path][k]: a scheme's exponent less that of the equation on the same path.
  Eigen::MatrixXd differences(std::size_t scheme, int paths) const;
  Eigen::MatrixXd rates(std::size_t scheme, int paths) const { return found_[scheme].rates.topRows(paths); }
  /// [component][lane] of the first block, where its paths end.
  std::span<const double> last_states(std::size_t scheme) const { return last_states_[scheme]; }

 private:
  void run(int block, std::span<const int> open);

  const context& context_;
  const orbit_frame& frame_;
  const std::vector<scheme_entry>& schemes_;
  const observed_rates& of_equation_;
  int vectors_;
  std::vector<std::unique_ptr<tangent_flow>> flows_;  // [scheme]
  std::vector<observed_rates> found_;                 // the same
  std::vector<std::vector<double>> last_states_;      // the same
  std::vector<sample_size> sizes_;
};

/// Growth of Liouville's volume less the mean divergence, [path], of one block of a scheme: 2 e(dt/2) - e(dt), e(dt)
/// taken over the same time at both steps, so that an error of order one in dt is gone.
Eigen::VectorXd volume_defects(const context&, const orbit_frame&, const scheme_entry&);

}  // namespace polhode
