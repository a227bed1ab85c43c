// SPDX-License-Identifier: Apache-2.0
#include "sphere/products/pair_generator.hpp"

#include <algorithm>
#include <cmath>

#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/observables.hpp"
#include "sphere/products/pair_harmonics.hpp"

namespace polhode {
namespace {

struct product_term {
  sparse_matrix first, second;  ///< of functions of x_1, and of x_2
};

sparse_matrix identity(int degree) {
  sparse_matrix one(harmonic_count(degree), harmonic_count(degree));
  one.setIdentity();
  return one;
}

/// Of a site, in a field along an axis that its partner of that radius makes.
sparse_matrix drift_by_exchange(const sphere_problem& site, double exchange, double radius, int axis, int degree) {
  const sphere_problem in_field{Eigen::Matrix3d::Zero(), site.damping, site.radius, Eigen::Matrix3d::Zero(),
                                exchange * radius * Eigen::Vector3d::Unit(axis)};
  return backward_operator(in_field, degree);
}

std::vector<product_term> terms_of(const sphere_pair& p, int degree) {
  const auto& [one, other] = p.sites;
  const auto x = coordinates(degree), turn = rotation_generators(degree);
  std::vector<product_term> terms{{backward_operator(one, degree), identity(degree)},
                                  {identity(degree), backward_operator(other, degree)}};
  for (int j = 0; j < 3; ++j) {
    const auto at = static_cast<std::size_t>(j);
    if (p.exchange != 0) {
      terms.push_back({drift_by_exchange(one, p.exchange, other.radius, j, degree), x[at]});
      terms.push_back({x[at], drift_by_exchange(other, p.exchange, one.radius, j, degree)});
    }
    for (int k = 0; k < 3; ++k)
      if (p.between(j, k) != 0) terms.push_back({p.between(j, k) * turn[at], turn[static_cast<std::size_t>(k)]});
  }
  return terms;
}

/// Adds up one column after another; what cancelled is not there, as it would tie together blocks that do not talk to
/// each other.
class column_sum {
 public:
  explicit column_sum(int rows) : sum_(Eigen::VectorXd::Zero(rows)), sizes_(Eigen::VectorXd::Zero(rows)) {}
  void add(int row, double value) {
    if (sizes_[row] == 0) touched_.push_back(row);
    sum_[row] += value;
    sizes_[row] += std::fabs(value);
  }
  void write(sparse_matrix& out, int column) {
    std::ranges::sort(touched_);
    out.startVec(column);
    for (const int row : touched_) {
      if (std::fabs(sum_[row]) > rounding_of_sums * sizes_[row]) out.insertBack(row, column) = sum_[row];
      sum_[row] = sizes_[row] = 0;
    }
    touched_.clear();
  }

 private:
  Eigen::VectorXd sum_, sizes_;
  std::vector<int> touched_;
};

}  // namespace

sparse_matrix tall_backward_operator(const sphere_pair& pair, int degree) {
  const auto terms = terms_of(pair, degree + 2);
  const pair_index index(degree + 2);
  sparse_matrix out(pair_harmonic_count(degree + 2), pair_harmonic_count(degree));
  column_sum sum(static_cast<int>(out.rows()));
  const auto write = [&](int k, int n) {
    for (const auto& [first, second] : terms)
      for (sparse_matrix::InnerIterator a(first, k); a; ++a)
        for (sparse_matrix::InnerIterator b(second, n); b; ++b)
          if (const double product = a.value() * b.value(); product != 0)
            sum.add(index(static_cast<int>(a.row()), static_cast<int>(b.row())), product);
    sum.write(out, index(k, n));
  };
  for (int both = 0; both <= degree; ++both)
    for (int l1 = 0; l1 <= both; ++l1)
      for (int k = l1 * l1; k < harmonic_count(l1); ++k)
        for (int l2 = both - l1, n = l2 * l2; n < harmonic_count(l2); ++n) write(k, n);
  out.finalize();
  return out;
}

}  // namespace polhode
