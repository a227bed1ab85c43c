// Noise with constant vectors sigma_i in a Lie algebra: sum_i sigma_i o dW^i acting by the coadjoint action.
#pragma once

#include <Eigen/Dense>
#include <span>

#include <polhode/increment.hpp>
#include <polhode/vec.hpp>

namespace polhode {

/// On this depend the orders that a scheme may claim. One vector commutes with itself; isotropic: sum sigma sigma^T =
/// s^2 1.
enum class noise_class { none, one_vector, isotropic, general };

template <class Algebra>
class constant_noise {
 public:
  static constexpr int dimension = Algebra::dimension;
  static constexpr int channels = dimension;
  using matrix = Eigen::Matrix<double, dimension, dimension>;
  using column = vec<double, dimension>;

  constant_noise() : constant_noise(matrix::Zero().eval()) {}

  /// The columns are the vectors; unused ones are zero.
  explicit constant_noise(const matrix& columns) : sigma_(columns) {
    for (int i = 0; i < channels; ++i)
      for (int k = 0; k < dimension; ++k) vectors_[i][k] = columns(k, i);
    int pair = 0;
    for (int i = 0; i < channels; ++i)
      for (int j = i + 1; j < channels; ++j) brackets_[pair++] = Algebra::bracket(vectors_[i], vectors_[j]);
  }

  /// sigma e_1, …, sigma e_n.
  static constant_noise isotropic(double strength) { return constant_noise(matrix(strength * matrix::Identity())); }

  /// Any list. More vectors than dimensions are replaced by the symmetric square root of sum sigma sigma^T: the
  /// algebra-valued Brownian motion sum sigma_i W^i has the same law, hence so has the solution.
  static constant_noise from_vectors(std::span<const column> list) {
    matrix covariance = matrix::Zero(), columns = matrix::Zero();
    int next = 0;
    for (const column& v : list) {
      Eigen::Matrix<double, dimension, 1> e;
      for (int k = 0; k < dimension; ++k) e[k] = v[k];
      covariance += e * e.transpose();
      if (next < channels && !e.isZero(0.0)) columns.col(next) = e;
      if (!e.isZero(0.0)) ++next;
    }
    return constant_noise(next <= channels ? columns : square_root_of(covariance));
  }

  const matrix& sigma() const { return sigma_; }

  noise_class classify() const {
    const matrix covariance = sigma_ * sigma_.transpose();
    const double scale = covariance.trace() / dimension;
    if (scale == 0) return noise_class::none;
    Eigen::FullPivLU<matrix> rank(sigma_);
    if (rank.rank() == 1) return noise_class::one_vector;
    return (covariance - scale * matrix::Identity()).norm() <= 1e-12 * scale ? noise_class::isotropic
                                                                             : noise_class::general;
  }

  /// How many channels any scheme can see: none, one, or all (weak_order_two spreads two vectors over three).
  int active_channels() const {
    const auto kind = classify();
    return kind == noise_class::none                                                       ? 0
           : kind == noise_class::one_vector && sigma_.rightCols(channels - 1).isZero(0.0) ? 1
                                                                                           : channels;
  }

  /// sum_i sigma_i dW^i.
  template <class S>
  vec<S, dimension> noise(const vec<S, channels>& dw) const {
    vec<S, dimension> sum = S(dw[0]) * lifted<S>(vectors_[0]);
    for (int i = 1; i < channels; ++i) sum = sum + dw[i] * lifted<S>(vectors_[i]);
    return sum;
  }

  /// sum_{i<j} A^ij [sigma_i, sigma_j]: the area term of the Magnus series of dmu = ad*_{sigma o dW} mu.
  template <class S>
  vec<S, dimension> area_noise(const vec<S, pairs_of<channels>>& area) const {
    vec<S, dimension> sum = area[0] * lifted<S>(brackets_[0]);
    for (int pair = 1; pair < pairs_of<channels>; ++pair) sum = sum + area[pair] * lifted<S>(brackets_[pair]);
    return sum;
  }

  /// The drift that turns Stratonovich into Ito: 1/2 sum_i ad*_{sigma_i} ad*_{sigma_i} mu (paper, eq. 2.3).
  template <class S>
  vec<S, dimension> ito_drift(const vec<S, dimension>& mu) const {
    vec<S, dimension> sum{};
    for (int i = 0; i < channels; ++i) {
      const auto s = lifted<S>(vectors_[i]);
      sum = sum + Algebra::coad(s, Algebra::coad(s, mu));
    }
    return S(0.5) * sum;
  }

  /// Noise vectors T(dt) for which one exponential of T dW has the law of the Brownian motion on the group to weak
  /// order two, for any sigma on any Lie algebra. With X_i the vector fields of sigma_i,
  ///   exp(dt/2 sum X_i^2) - E exp(sum X_i dW^i) = dt^2/2 sum_ab R_ab e_a e_b + O(dt^3),
  ///   R = (M Q + Q M^T)/12 + 1/4 sum_{i<j} [sigma_i,sigma_j][sigma_i,sigma_j]^T,
  ///   Q = sum sigma_i sigma_i^T,  M = sum_i ad(sigma_i)^2,
  /// so that the covariance Q dt + R dt^2 removes the defect (both sides expanded to dt^2: the words iijj, ijij, ijji
  /// carry 1/8, 0, 0 on the left; 1/24 each on the right, plus 1/12, -1/6, 1/12 from M and 0, 1/8, -1/8 from the
  /// brackets). Isotropic noise on so(3): R = -sigma^4/12, the factor sqrt(1 - sigma^2 dt/12). One vector: R = 0.
  /// T(dt) -> sigma as dt -> 0. Where dt is so large that Q + R dt is indefinite its negative part is dropped.
  constant_noise weak_order_two(double dt) const {
    const matrix covariance = sigma_ * sigma_.transpose();
    matrix m = matrix::Zero(), r = matrix::Zero();
    for (int i = 0; i < channels; ++i) {
      const matrix ad = adjoint(vectors_[i]);
      m += ad * ad;
    }
    for (const column& b : brackets_.c) {
      const Eigen::Map<const Eigen::Matrix<double, dimension, 1>> e(b.c.data());
      r += 0.25 * e * e.transpose();
    }
    r += (m * covariance + covariance * m.transpose()) / 12.0;
    const Eigen::JacobiSVD<matrix> svd(sigma_, Eigen::ComputeFullU | Eigen::ComputeFullV);
    return constant_noise(matrix(square_root_of(covariance + dt * r) * svd.matrixU() * svd.matrixV().transpose()));
  }

 private:
  template <class S>
  static vec<S, dimension> lifted(const column& v) {
    vec<S, dimension> out;
    for (int k = 0; k < dimension; ++k) out[k] = S(v[k]);
    return out;
  }
  static matrix square_root_of(const matrix& symmetric) {
    const Eigen::SelfAdjointEigenSolver<matrix> eigen(symmetric);
    return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal() *
           eigen.eigenvectors().transpose();
  }
  static matrix adjoint(const column& v) {
    matrix ad;
    for (int k = 0; k < dimension; ++k) {
      column e{};
      e[k] = 1;
      const column image = Algebra::bracket(v, e);
      for (int row = 0; row < dimension; ++row) ad(row, k) = image[row];
    }
    return ad;
  }

  matrix sigma_;
  vec<column, channels> vectors_{};             ///< the columns of sigma
  vec<column, pairs_of<channels>> brackets_{};  ///< [sigma_i, sigma_j], i < j
};

}  // namespace polhode
