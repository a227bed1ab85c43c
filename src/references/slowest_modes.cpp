#include "references/slowest_modes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "references/decompositions.hpp"

namespace polhode {
namespace {

using complex = std::complex<double>;
using complex_matrix = Eigen::SparseMatrix<complex>;

constexpr int most_dense = 400;    // unknowns: a second
constexpr int krylov = 30;         // vectors
constexpr double is_found = 1e-6;  // remainder of a Ritz value, relative
constexpr double settled = 1e-13;  // relative change of the rate
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
  const Eigen::Index most = std::min<Eigen::Index>(krylov, a.rows());
  Eigen::MatrixXd basis = Eigen::MatrixXd::Zero(a.rows(), most + 1), h = Eigen::MatrixXd::Zero(most + 1, most);
  basis.col(0) = any_vector(a.rows());
  for (Eigen::Index k = 0; k < most; ++k) {
    const Eigen::VectorXd last = basis.col(k);
    Eigen::VectorXd next = lu.solve(last);
    for (int pass = 0; pass < 2; ++pass) {
      const Eigen::VectorXd along = basis.leftCols(k + 1).transpose() * next;
      next -= basis.leftCols(k + 1) * along;
      h.col(k).head(k + 1) += along;
    }
    h(k + 1, k) = next.norm();
    basis.col(k + 1) = next / h(k + 1, k);
  }
  if (!h.allFinite()) return -infinity;
  const Eigen::EigenSolver<Eigen::MatrixXd> ritz(h.topRows(most));
  complex slowest = -infinity;
  for (Eigen::Index i = 0; i < most; ++i) {
    const complex inverse = ritz.eigenvalues()[i];
    const double remainder = h(most, most - 1) * std::abs(ritz.eigenvectors()(most - 1, i));
    if (remainder <= is_found * std::abs(inverse) && (1.0 / inverse).real() > slowest.real()) slowest = 1.0 / inverse;
  }
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
  return slowest_of(Eigen::EigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(a), false).eigenvalues());
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
    if (std::abs(found - std::exchange(out.rate, found)) <= settled * std::abs(found)) break;
  }
  out.condition = 1 / std::abs(left.cwiseProduct(out.right).sum());
  const double products = left.cwiseAbs().dot(a.cwiseAbs() * out.right.cwiseAbs());
  out.rounding = 4 * std::numeric_limits<double>::epsilon() * out.condition * products;
  return out;
}

}  // namespace polhode
