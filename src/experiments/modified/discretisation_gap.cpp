// SPDX-License-Identifier: Apache-2.0
#include "experiments/modified/discretisation_gap.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>

#include "algebra/krylov_space.hpp"
#include "algebra/slowest_modes.hpp"
#include "algebra/sparse_blocks.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/spectral_gap.hpp"

namespace polhode {
namespace {

constexpr int krylov = 60;          // vectors
constexpr double is_found = 1e-9;   // remainder of a Ritz value, relative
constexpr double accuracy = 1e-12;  // of the equation's gap, absolute
constexpr double certain = 1e-6;    // of it, relative: what it must be known to

// No symmetry of its own.
Eigen::VectorXd any_vector(Eigen::Index size) {
  return Eigen::VectorXd::NullaryExpr(
             size, [](Eigen::Index i) { return std::sin(1.0 + double(i * i % 1009)) / double(i + 9); })
      .normalized();
}

/// Empty where no mode of that rate is found.
Eigen::VectorXcd slowest_mode(const sphere_problem& problem, const reference_value& gap) {
  const sparse_matrix whole = backward_operator(problem, gap.degree);
  const sparse_matrix relaxing = whole.bottomRightCorner(whole.rows() - 1, whole.cols() - 1);
  for (const index_set& block : connected_blocks(relaxing)) {
    const sparse_matrix part = submatrix(relaxing, block);
    const auto rate = slowest_rate(part);
    if (!(std::fabs(-rate.real() - *gap.value) <= certain * *gap.value)) continue;
    Eigen::VectorXcd mode = Eigen::VectorXcd::Zero(relaxing.rows());
    mode(block) = eigenpair_near(part, rate).right;
    return mode;
  }
  return {};
}

/// The cosine between two functions in harmonics, of which one may go on to higher degrees.
double likeness(const Eigen::VectorXcd& a, const Eigen::VectorXcd& b) {
  const auto both = std::min(a.size(), b.size());
  return both == 0 ? 0 : std::abs(a.head(both).dot(b.head(both))) / (a.norm() * b.norm());
}

}  // namespace

known_gap true_gap(const subject& s) {
  const auto problem = *s.sphere();
  const auto found = spectral_gap(problem, accuracy);
  if (!found.value) return {{}, found.reason, false};
  if (*found.value == 0) return {{}, "a function besides the Casimir is conserved", false};
  if (!(found.uncertainty <= certain * *found.value)) return {{}, found.reason, true};
  const auto one = [](double x) { return Eigen::VectorXd::Constant(1, x); };
  return {{{"spectral gap"}, {}, one(*found.value), one(found.uncertainty), one(*found.value)},
          "",
          false,
          slowest_mode(problem, found)};
}

double discretisation_gap(const Eigen::MatrixXd& forgetting, double dt, const Eigen::VectorXcd& mode, double error) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  krylov_space space([&](const Eigen::VectorXd& v) -> Eigen::VectorXd { return forgetting * v; },
                     any_vector(forgetting.rows()), krylov);
  space.grow(krylov);
  double slowest = none, followed = none, likest = 0;
  for (const auto& ritz : space.ritz_pairs()) {
    if (!(ritz.remainder <= is_found * std::abs(ritz.value))) continue;
    const double gap = -std::log(std::abs(1.0 - 1.0 / ritz.value)) / dt;
    slowest = std::fmin(slowest, gap);
    const double like = likeness(mode, space.basis() * ritz.vector);
    if (like <= likest) continue;
    likest = like;
    followed = gap;
  }
  return followed <= slowest + error ? followed : slowest;
}

}  // namespace polhode
