// SPDX-License-Identifier: Apache-2.0
#include "experiments/lyapunov/orbit_geometry.hpp"

#include <Eigen/LU>
#include <Eigen/QR>
#include <array>
#include <cmath>

#include "ensemble/coadjoint_matrices.hpp"

namespace polhode {
namespace {

constexpr double rank_threshold = 1e-9;
constexpr double difference_step = 1e-2;  // of |mu|

}  // namespace

orbit_geometry::orbit_geometry(const model& m, std::span<const double> momentum)
    : model_(m), coadjoint_(coadjoint_matrices(m)) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(
      poisson_tensor(Eigen::Map<const Eigen::VectorXd>(momentum.data(), m.dimension())));
  qr.setThreshold(rank_threshold);
  dimension_ = static_cast<int>(qr.rank());
}

Eigen::MatrixXd orbit_geometry::poisson_tensor(const Eigen::VectorXd& mu) const {
  Eigen::MatrixXd out(mu.size(), mu.size());
  for (Eigen::Index k = 0; k < mu.size(); ++k) out.col(k) = coadjoint_[static_cast<std::size_t>(k)] * mu;
  return out;
}

Eigen::MatrixXd orbit_geometry::tangents(const Eigen::VectorXd& mu) const {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(poisson_tensor(mu));
  return qr.householderQ() * Eigen::MatrixXd::Identity(mu.size(), dimension_);
}

double orbit_geometry::log_density(const Eigen::VectorXd& mu) const {
  const Eigen::MatrixXd basis = tangents(mu), form = basis.transpose() * poisson_tensor(mu) * basis;
  return -0.5 * std::log(std::fabs(form.determinant()));
}

Eigen::VectorXd orbit_geometry::divergences(std::span<const double> states) const {
  using lanes = Eigen::Array<double, block_lanes, 1>;
  std::vector<double> moved(states.begin(), states.end()), drift(states.size());
  const Eigen::Map<const Eigen::Array<double, block_lanes, Eigen::Dynamic>> mu(states.data(), block_lanes,
                                                                               model_.dimension());
  const lanes h = difference_step * mu.square().rowwise().sum().sqrt();
  lanes sum = lanes::Zero();
  for (Eigen::Index k = 0; k < mu.cols(); ++k) {
    Eigen::Map<lanes> own(moved.data() + k * block_lanes);
    const Eigen::Map<const lanes> found(drift.data() + k * block_lanes);
    const auto at = [&](double steps) -> lanes {
      own = mu.col(k) + steps * h;
      model_.drifts(moved, drift);
      return found;
    };
    sum += (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * h);
    own = mu.col(k);
  }
  return sum;
}

}  // namespace polhode
