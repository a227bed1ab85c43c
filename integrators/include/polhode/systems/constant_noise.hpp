// SPDX-License-Identifier: Apache-2.0
// Noise with constant vectors sigma_i in a Lie algebra: sum_i sigma_i o dW^i acting by the coadjoint action.
#pragma once

#include <Eigen/Core>
#include <span>

#include <polhode/increment.hpp>
#include <polhode/systems/noise_matrix.hpp>
#include <polhode/vec.hpp>

namespace polhode {

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

  noise_class classify() const { return class_of(sigma_); }

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

  /// Noise vectors for which one exponential has the law of the Brownian motion on the group to weak order two
  /// (noise_matrix.hpp).
  constant_noise weak_order_two(double dt) const {
    return constant_noise(weak_order_two_vectors<Algebra>(sigma_, brackets_, dt));
  }

 private:
  template <class S>
  static vec<S, dimension> lifted(const column& v) {
    vec<S, dimension> out;
    for (int k = 0; k < dimension; ++k) out[k] = S(v[k]);
    return out;
  }

  matrix sigma_;
  vec<column, channels> vectors_{};             ///< the columns of sigma
  vec<column, pairs_of<channels>> brackets_{};  ///< [sigma_i, sigma_j], i < j
};

}  // namespace polhode
