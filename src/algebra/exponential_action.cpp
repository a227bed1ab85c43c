// SPDX-License-Identifier: Apache-2.0
#include "algebra/exponential_action.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace polhode {
namespace {

constexpr int terms = 55;
constexpr double reach = 9.9;  // theta_55 of the source: the norm that 55 terms carry

double shift_of(const Eigen::SparseMatrix<double>& a) { return a.diagonal().sum() / static_cast<double>(a.rows()); }

std::int64_t steps_needed(const Eigen::SparseMatrix<double>& a, double t) {
  const double shift = shift_of(a);
  double norm = 0;  // of A - shift, largest column sum
  for (int column = 0; column < a.outerSize(); ++column) {
    double sum = 0, diagonal = 0;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(a, column); entry; ++entry)
      (entry.row() == column ? diagonal : sum) += entry.row() == column ? entry.value() : std::fabs(entry.value());
    norm = std::max(norm, sum + std::fabs(diagonal - shift));
  }
  return static_cast<std::int64_t>(std::min(std::max(1.0, std::ceil(t * norm / reach)), 0x1p53));
}

}  // namespace

Eigen::VectorXd exponential_action(const Eigen::SparseMatrix<double>& a, double t, Eigen::VectorXd b,
                                   const std::function<bool(const Eigen::VectorXd&, double dt)>& watch) {
  const Eigen::SparseMatrix<double, Eigen::RowMajor> rows = a;  // a row times a vector is the faster product
  const std::int64_t steps = steps_needed(a, t);
  const double shift = shift_of(a), dt = t / static_cast<double>(steps);
  Eigen::VectorXd term, next;
  for (std::int64_t step = 0; step < steps; ++step) {
    term = b;
    double before = term.lpNorm<Eigen::Infinity>();
    for (int k = 1; k <= terms; ++k) {
      next.noalias() = rows * term;
      term = (dt / k) * (next - shift * term);
      b += term;
      const double size = term.lpNorm<Eigen::Infinity>();
      if (size + before <= std::numeric_limits<double>::epsilon() / 2 * b.lpNorm<Eigen::Infinity>()) break;
      before = size;
    }
    b *= std::exp(shift * dt);
    if (watch && !watch(b, dt)) break;
    if (!b.allFinite()) break;  // grown beyond all numbers: more steps would not mend it
  }
  return b;
}

double exponential_action_products(const Eigen::SparseMatrix<double>& a, double t) {
  return 40 * static_cast<double>(steps_needed(a, t));  // the series ends before its last term
}

}  // namespace polhode
