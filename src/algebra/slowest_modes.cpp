// SPDX-License-Identifier: Apache-2.0
#include "algebra/slowest_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algebra/decompositions.hpp"
#include "algebra/krylov_space.hpp"

namespace polhode {
namespace {

using complex = std::complex<double>;
using complex_matrix = Eigen::SparseMatrix<complex>;

constexpr int most_dense = 400;      // unknowns: a second
constexpr int krylov = 30;           // vectors
constexpr double is_found = 1e-6;    // remainder of a Ritz value, relative
constexpr double converged = 1e-13;  // relative change of the rate
constexpr int most_iterations = 30;
constexpr double infinity = std::numeric_limits<double>::infinity();

complex slowest_of(const Eigen::VectorXcd& rates) {
  return *std::ranges::max_element(rates, {}, [](complex z) { return z.real(); });
}

// No symmetry of its own.
Eigen::VectorXd any_vector(Eigen::Index size) {
  return Eigen::VectorXd::NullaryExpr(size, [](Eigen::Index i) { return std::sin(1.0 + double(i * i % 1009)); })
      .normalized();
}

complex slowest_near_zero(const sparse_matrix& a) {
  const Eigen::SparseLU<sparse_matrix> lu(a);
  if (lu.info() != Eigen::Success) return -infinity;
  krylov_space inverse([&](const Eigen::VectorXd& v) -> Eigen::VectorXd { return lu.solve(v); }, any_vector(a.rows()),
                       krylov);
  inverse.grow(krylov);
  complex slowest = -infinity;
  for (const auto& mode : inverse.ritz_pairs())
    if (mode.remainder <= is_found * std::abs(mode.value) && (1.0 / mode.value).real() > slowest.real())
      slowest = 1.0 / mode.value;
  return slowest;
}

complex_matrix shifted(const sparse_matrix& a, complex shift) {
  complex_matrix out = a.cast<complex>();
  for (int i = 0; i < out.rows(); ++i) out.coeffRef(i, i) -= shift;
  out.makeCompressed();
  return out;
}

}  // namespace

complex slowest_rate(const sparse_matrix& a) {
  if (a.rows() > most_dense) return slowest_near_zero(a);
  return slowest_of(eigenvalues_of(Eigen::MatrixXd(a)));
}

eigenpair eigenpair_near(const sparse_matrix& a, complex guess) {
  const complex shift = guess + 1e-7 * std::abs(guess);
  const Eigen::SparseLU<complex_matrix> lu(shifted(a, shift)), transposed(shifted(a.transpose(), shift));
  eigenpair out{infinity, any_vector(a.rows()).cast<complex>(), infinity, infinity};
  if (lu.info() != Eigen::Success || transposed.info() != Eigen::Success) return out;
  const complex_matrix whole = a.cast<complex>();
  Eigen::VectorXcd left = out.right;
  for (int k = 0; k < most_iterations; ++k) {
    const Eigen::VectorXcd right = lu.solve(out.right), other = transposed.solve(left);
    out.right = right.normalized();
    left = other.normalized();
    const complex found = left.cwiseProduct(whole * out.right).sum() / left.cwiseProduct(out.right).sum();
    if (std::abs(found - std::exchange(out.rate, found)) <= converged * std::abs(found)) break;
  }
  out.condition = 1 / std::abs(left.cwiseProduct(out.right).sum());
  const double products = left.cwiseAbs().dot(a.cwiseAbs() * out.right.cwiseAbs());
  out.rounding = 4 * std::numeric_limits<double>::epsilon() * out.condition * products;
  return out;
}

}  // namespace polhode
