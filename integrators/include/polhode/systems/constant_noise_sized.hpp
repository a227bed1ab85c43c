// SPDX-License-Identifier: Apache-2.0
// constant_noise on an algebra whose dimension is known at run time alone, Algebra::dimension < 0.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include <polhode/increment.hpp>
#include <polhode/systems/constant_noise.hpp>
#include <polhode/systems/noise_matrix.hpp>
#include <polhode/vec.hpp>

namespace polhode {

/// As the general one (constant_noise.hpp). Vectors and brackets are kept by their entries that are not zero, as few
/// are; copies share them.
template <class Algebra>
requires(Algebra::dimension < 0) class constant_noise<Algebra> {
 public:
  static constexpr int dimension = Algebra::dimension;
  static constexpr int channels = dimension;
  using matrix = Eigen::MatrixXd;
  using column = vec<double, dimension>;

  /// The columns are the vectors; unused ones are zero.
  explicit constant_noise(matrix columns) : parts_(std::make_shared<parts>(std::move(columns))) {}

  /// sigma e_1, …, sigma e_n.
  static constant_noise isotropic(double strength, int n) {
    return constant_noise(matrix(strength * matrix::Identity(n, n)));
  }

  /// Any list of vectors of n components; more of them than components as their square root.
  static constant_noise from_vectors(std::span<const std::vector<double>> list, int n) {
    matrix all(n, static_cast<Eigen::Index>(list.size()));
    for (std::size_t i = 0; i < list.size(); ++i)
      all.col(static_cast<Eigen::Index>(i)) = Eigen::Map<const Eigen::VectorXd>(list[i].data(), n);
    if (all.cols() > n) return constant_noise(square_root_of(square_of(all)));
    matrix columns = matrix::Zero(n, n);
    columns.leftCols(all.cols()) = all;
    return constant_noise(columns);
  }

  int components() const { return static_cast<int>(parts_->sigma.rows()); }
  const matrix& sigma() const { return parts_->sigma; }
  noise_class classify() const { return parts_->kind; }

  int active_channels() const {
    return classify() == noise_class::none                                                            ? 0
           : classify() == noise_class::one_vector && sigma().rightCols(components() - 1).isZero(0.0) ? 1
                                                                                                      : components();
  }

  template <class S>
  vec<S, dimension> noise(const vec<S, channels>& dw) const {
    return sum_of(parts_->vectors, dw);
  }
  template <class S>
  vec<S, dimension> area_noise(const vec<S, pairs_of<channels>>& area) const {
    return sum_of(parts_->brackets, area);
  }

  template <class S>
  vec<S, dimension> ito_drift(const vec<S, dimension>& mu) const {
    vec<S, dimension> sum;
    for (int i = 0; i < components(); ++i) {
      vec<S, dimension> s(components());
      for (int k = 0; k < components(); ++k) s[k] = S(sigma()(k, i));
      sum = sum + Algebra::coad(s, Algebra::coad(s, mu));
    }
    return S(0.5) * sum;
  }

  constant_noise weak_order_two(double dt) const {
    return constant_noise(weak_order_two_vectors<Algebra>(sigma(), brackets_of(sigma()), dt));
  }

 private:
  struct entry {
    int from, component;
    double factor;
  };

  static column column_of(const matrix& m, int i) {
    column out(static_cast<int>(m.rows()));
    for (int k = 0; k < out.size; ++k) out[k] = m(k, i);
    return out;
  }
  static std::vector<column> brackets_of(const matrix& m) {
    std::vector<column> out;
    for (int i = 0; i < m.cols(); ++i)
      for (int j = i + 1; j < m.cols(); ++j) out.push_back(Algebra::bracket(column_of(m, i), column_of(m, j)));
    return out;
  }

  struct parts {
    explicit parts(matrix columns) : sigma(std::move(columns)), kind(class_of(sigma)) {
      for (int i = 0; i < sigma.cols(); ++i) add(vectors, i, column_of(sigma, i));
      int pair = 0;
      for (const auto& b : brackets_of(sigma)) add(brackets, pair++, b);
    }
    static void add(std::vector<entry>& out, int from, const column& v) {
      for (int k = 0; k < v.size; ++k)
        if (v[k] != 0) out.push_back({from, k, v[k]});
    }
    matrix sigma;
    noise_class kind;
    std::vector<entry> vectors, brackets;
  };

  template <class S, int N>
  vec<S, dimension> sum_of(const std::vector<entry>& entries, const vec<S, N>& weights) const {
    vec<S, dimension> sum(components());
    if (weights.size == 0) return sum;
    for (const auto& [from, component, factor] : entries) sum[component] = sum[component] + S(factor) * weights[from];
    return sum;
  }

  std::shared_ptr<const parts> parts_;
};

}  // namespace polhode
