// SPDX-License-Identifier: Apache-2.0
// Representations of an algebra as matrices, the mean of an exponential in them, and how far it is from Brownian motion
// on the group.
#pragma once

#include <gsl/gsl_integration.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <unsupported/Eigen/KroneckerProduct>
#include <vector>

#include <polhode/vec.hpp>

#include "support/dense.hpp"

namespace polhode::test {

using Eigen::MatrixXd;

/// ad*_{e_k} on the coordinates first … first + 2, every k: a representation of the algebra, the order of products
/// reversed.
template <class Algebra>
std::vector<MatrixXd> vectors(int first) {
  std::vector<MatrixXd> out;
  for (int k = 0; k < Algebra::dimension; ++k) {
    MatrixXd c(3, 3);
    for (int column = 0; column < 3; ++column) {
      vec<double, Algebra::dimension> e{}, mu{};
      e[k] = 1;
      mu[first + column] = 1;
      const auto image = Algebra::coad(e, mu);
      for (int row = 0; row < 3; ++row) c(row, column) = image[first + row];
    }
    out.push_back(c);
  }
  return out;
}

inline std::vector<MatrixXd> tensor(const std::vector<MatrixXd>& a, const std::vector<MatrixXd>& b) {
  const MatrixXd one = MatrixXd::Identity(3, 3);
  std::vector<MatrixXd> out;
  for (std::size_t k = 0; k < a.size(); ++k)
    out.emplace_back(MatrixXd(Eigen::kroneckerProduct(a[k], one)) + MatrixXd(Eigen::kroneckerProduct(one, b[k])));
  return out;
}

/// Of the vector v in the algebra.
inline MatrixXd represented(const std::vector<MatrixXd>& generators, const Eigen::VectorXd& v) {
  MatrixXd sum = MatrixXd::Zero(generators[0].rows(), generators[0].cols());
  for (std::size_t k = 0; k < generators.size(); ++k) sum += v[static_cast<Eigen::Index>(k)] * generators[k];
  return sum;
}

/// E exp(C(T sqrt(dt) g)), g standard normal: exact to degree 2 nodes - 1 in each component.
inline MatrixXd mean_exponential(const std::vector<MatrixXd>& generators, const MatrixXd& t, double dt, int nodes) {
  const std::unique_ptr<gsl_integration_fixed_workspace, decltype(&gsl_integration_fixed_free)> rule(
      gsl_integration_fixed_alloc(gsl_integration_fixed_hermite, static_cast<std::size_t>(nodes), 0, 0.5, 0, 0),
      gsl_integration_fixed_free);
  const double* x = gsl_integration_fixed_nodes(rule.get());
  const double* w = gsl_integration_fixed_weights(rule.get());
  const auto n = t.cols();
  MatrixXd sum = MatrixXd::Zero(generators[0].rows(), generators[0].cols());
  std::vector<int> index(static_cast<std::size_t>(n));
  for (int digit = 0; digit < n;) {
    Eigen::VectorXd g(n);
    double weight = 1;
    for (Eigen::Index i = 0; i < n; ++i) {
      g[i] = x[index[static_cast<std::size_t>(i)]];
      weight *= w[index[static_cast<std::size_t>(i)]] / std::sqrt(2 * std::numbers::pi);
    }
    sum += weight * exponential_of(represented(generators, std::sqrt(dt) * t * g));
    for (digit = 0; digit < n && ++index[static_cast<std::size_t>(digit)] == nodes; ++digit)
      index[static_cast<std::size_t>(digit)] = 0;
  }
  return sum;
}

inline double defect(const std::vector<MatrixXd>& generators, const MatrixXd& sigma, const MatrixXd& t, double dt,
                     int nodes = 10) {
  MatrixXd squares = MatrixXd::Zero(generators[0].rows(), generators[0].cols());
  for (Eigen::Index i = 0; i < sigma.cols(); ++i) {
    const MatrixXd c = represented(generators, sigma.col(i));
    squares += c * c;
  }
  return (exponential_of(0.5 * dt * squares) - mean_exponential(generators, t, dt, nodes)).norm();
}

/// The slope between dt and dt/2.
template <class Vectors>
double slope(const std::vector<MatrixXd>& generators, const MatrixXd& sigma, double dt, Vectors t, int nodes = 10) {
  return std::log2(defect(generators, sigma, t(dt), dt, nodes) / defect(generators, sigma, t(dt / 2), dt / 2, nodes));
}

}  // namespace polhode::test
