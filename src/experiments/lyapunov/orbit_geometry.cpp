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

double orbit_geometry::divergence(const Eigen::VectorXd& mu) const {
  const double h = difference_step * mu.norm();
  const auto n = static_cast<std::size_t>(mu.size());
  Eigen::VectorXd x = mu, out(mu.size());
  double sum = 0;
  for (Eigen::Index k = 0; k < mu.size(); ++k) {
    const auto at = [&](double by) {
      x[k] = mu[k] + by;
      model_.drift({x.data(), n}, {out.data(), n});
      return out[k];
    };
    sum += (8 * (at(h) - at(-h)) - (at(2 * h) - at(-2 * h))) / (12 * h);
    x[k] = mu[k];
  }
  return sum;
}

}  // namespace polhode
