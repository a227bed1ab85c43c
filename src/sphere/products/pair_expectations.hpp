// SPDX-License-Identifier: Apache-2.0
// Expectations on a product of two spheres without sampling: E[f(Pi_T)] = (exp(T L) f)(Pi_0), L the generator
// (pair_generator.hpp). What a projection leaves out of L f proves a bar (sphere/galerkin/propagation.hpp); where three
// successive degrees tell more, they may, as on one sphere.
#pragma once

#include <functional>
#include <map>

#include "sphere/galerkin/propagation.hpp"
#include "sphere/galerkin/reference_value.hpp"
#include "sphere/products/pair_harmonics.hpp"

namespace polhode {

/// Beyond it no generator is affordable: some 10^5 functions.
inline constexpr int most_pair_degree = 24;

/// Of all observables at one time; the generators that one needs are kept for the others.
class pair_expectations {
 public:
  /// start: the first momentum and the second, of the lengths that the pair has; time >= 0.
  pair_expectations(const sphere_pair&, const Eigen::Matrix<double, 6, 1>& start, double time,
                    int most_degree = most_pair_degree);

  /// E[f], to that share of the observable's size (the root of its mean square over both spheres). wanted: the degree,
  /// 2 to most_pair_degree; 0 lets the program choose. Without noise: f on the one path there is.
  reference_value of(const site_observable&, double share, int wanted = 0);
  /// The same by the agreement of degrees alone. One exponential a degree, of the law of Pi_T, does for all
  /// observables.
  reference_value agreed(const site_observable&, double share);

 private:
  struct projection {
    Eigen::SparseMatrix<double> tall;
    Eigen::VectorXd start, law;  ///< law: empty until it is asked for; and where it is not affordable
    bool law_known = false;
  };
  using value_at_degree = std::function<std::optional<projected_value>(int degree, const Eigen::VectorXd& f)>;
  projection& at(int degree);
  const Eigen::VectorXd& law_at(int degree);
  reference_value raised(const site_observable&, double share, int wanted, const value_at_degree&) const;

  sphere_pair pair_;
  Eigen::Matrix<double, 6, 1> start_;
  double time_;
  int most_degree_;
  std::map<int, projection> known_;
};

}  // namespace polhode
