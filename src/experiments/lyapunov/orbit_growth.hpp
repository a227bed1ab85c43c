// SPDX-License-Identifier: Apache-2.0
// Growth of lengths and of Liouville's volume along the paths of a flow on its coadjoint orbit.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "ensemble/orbit_start.hpp"
#include "ensemble/tangent_kernel.hpp"
#include "experiments/lyapunov/orbit_geometry.hpp"

namespace polhode {

// States with any number of tangents through the steps of a noise: by the derivative of a scheme's own step, or by
// differences of neighbours, for a kernel that has no derivative. The two know nothing of each other.

class tangent_flow {
 public:
  virtual ~tangent_flow() = default;
  virtual double dt() const = 0;
  /// States [component][lane], tangents [vector][component][lane], of about length one: through all steps of the view.
  virtual void advance(std::span<double> states, std::span<double> tangents, const increment_view&) const = 0;
};

/// Two tangents at a time, each pair with the states anew. An even number of tangents.
std::unique_ptr<tangent_flow> derivative_flow(std::unique_ptr<tangent_kernel>);

/// Neighbours at `distance` times the tangents (Benettin, Galgani, Giorgilli, Strelcyn, Meccanica 15 (1980) 9).
std::unique_ptr<tangent_flow> neighbour_flow(std::unique_ptr<kernel>, double distance);

/// Of a block of paths over a time, per unit of it. `rates`, [lane][k]: the logarithmic growth of the k-th vector of an
/// orthonormal basis that the flow carries on (Benettin et al. 1980), which tends to lambda_k. `volume`: that of
/// Liouville's volume; `divergence`: the mean of the drift's along the path. Of the flow itself both are equal, path by
/// path and whatever the start, as the noise keeps the volume. Empty where nobody looks at them; the volume also where
/// fewer vectors are carried than span a tangent space.
struct orbit_rates {
  Eigen::MatrixXd rates;
  Eigen::VectorXd volume, divergence;
};

/// A block of paths from all over the orbit, each with so many random vectors of its tangent space.
class orbit_block {
 public:
  static constexpr int chunk = 8;          ///< steps between two looks at the tangents
  static constexpr int projected_at = 32;  ///< chunks after which what rounding puts beside the orbit is taken out

  /// volume: whether it is followed, which takes four drifts a component and chunk.
  orbit_block(const orbit_geometry&, const orbit_start&, std::uint64_t seed, std::uint64_t first_path, int vectors,
              bool volume = true);
  /// The same from these states on.
  orbit_block(const orbit_geometry&, std::vector<double> states, std::uint64_t seed, std::uint64_t first_path,
              int vectors, bool volume = true);

  /// Through a chunk of steps.
  void advance(const tangent_flow&, const increment_view&);

  /// Growth since the last call, or the beginning.
  orbit_rates read();

  std::span<const double> states() const { return states_; }

 private:
  /// Of a lane: the state, and one of the vectors.
  Eigen::VectorXd state(int lane) const;
  Eigen::VectorXd log_densities() const;
  void project();
  void orthonormalise();
  void begin();
  void follow_divergence(double passed);

  const orbit_geometry& geometry_;
  int vectors_;
  bool volume_;
  std::vector<double> states_, tangents_;
  std::int64_t chunks_ = 0;
  // Since `begin`:
  double time_ = 0;
  Eigen::MatrixXd grown_;                          ///< [lane][vector]
  Eigen::VectorXd density_, divergence_, passed_;  ///< at that time; now; its integral since then
};

}  // namespace polhode
