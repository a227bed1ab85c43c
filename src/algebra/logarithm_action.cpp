// SPDX-License-Identifier: Apache-2.0
#include "algebra/logarithm_action.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <unsupported/Eigen/MatrixFunctions>

#include "algebra/decompositions.hpp"
#include "algebra/krylov_space.hpp"

namespace polhode {
namespace {

constexpr std::array dimensions{4, 6, 8, 10, 12, 16, 20, 24, 32, 40};
constexpr double not_complex = 1e-14;  // of an eigenvalue

/// No eigenvalue of 1 + H on the negative axis, and none 0.
bool has_logarithm(const Eigen::MatrixXd& step) {
  const auto all = eigenvalues_of(step);
  return all.allFinite() && std::ranges::none_of(all, [](std::complex<double> z) {
           return z.real() <= 0 && std::fabs(z.imag()) <= not_complex * std::abs(z);
         });
}

std::optional<Eigen::VectorXd> logarithm_action(const Eigen::MatrixXd& t, const Eigen::VectorXd& b, double tolerance) {
  const double size = b.norm();
  if (!(size > 0)) return Eigen::VectorXd::Zero(t.rows());
  krylov_space space([&](const Eigen::VectorXd& v) -> Eigen::VectorXd { return t * v - v; }, b, dimensions.back());
  std::optional<Eigen::VectorXd> last;
  for (const int dimension : dimensions) {
    space.grow(dimension);
    if (!(space.scale() > 0)) return Eigen::VectorXd::Zero(t.rows());
    const Eigen::MatrixXd step =
        Eigen::MatrixXd(space.projected()) + Eigen::MatrixXd::Identity(space.size(), space.size());
    if (!has_logarithm(step)) return std::nullopt;
    const Eigen::VectorXd found = space.basis() * Eigen::MatrixXd(step.log()).col(0);
    if (space.closed() || (last && (found - *last).norm() <= tolerance * space.scale())) return size * found;
    last = found;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Eigen::MatrixXd> logarithm_action(const Eigen::MatrixXd& t, const Eigen::MatrixXd& b, double tolerance) {
  if (!t.allFinite()) return std::nullopt;
  Eigen::MatrixXd out(b.rows(), b.cols());
  for (Eigen::Index j = 0; j < b.cols(); ++j) {
    const auto column = logarithm_action(t, Eigen::VectorXd(b.col(j)), tolerance);
    if (!column) return std::nullopt;
    out.col(j) = *column;
  }
  return out;
}

}  // namespace polhode
