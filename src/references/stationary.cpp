// The stationary law and the spectral gap of references/kolmogorov.hpp.
#include <Eigen/Eigenvalues>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <utility>

#include "references/kolmogorov.hpp"
#include "references/raise_degree.hpp"
#include "references/sparse_blocks.hpp"

namespace polhode {
namespace {

using complex = std::complex<double>;

constexpr std::array degrees{8, 12, 16, 24, 32, 48, 64, 96};
constexpr int most_sparse = 5000, most_dense = 700;  // unknowns in a block: seconds
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double resolved = 0.1;     // relative change below which the slowest mode is followed to higher degrees
constexpr double conserved = 1e-11;  // an eigenvalue below this times |Q| is none

/// The generator without the constant function, in its blocks.
std::vector<sparse_matrix> relaxing_blocks(const sphere_problem& problem, int degree) {
  const sparse_matrix whole = backward_operator(problem, degree);
  const sparse_matrix rest = whole.block(1, 1, whole.rows() - 1, whole.cols() - 1);
  std::vector<sparse_matrix> parts;
  for (const index_set& block : connected_blocks(rest)) parts.push_back(submatrix(rest, block));
  return parts;
}

complex slowest_dense(const sparse_matrix& part) {
  const Eigen::VectorXcd all = Eigen::EigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(part), false).eigenvalues();
  return *std::ranges::max_element(all, {}, [](complex z) { return z.real(); });
}

/// The eigenvalue next to the guess, by inverse iteration.
complex next_to(const sparse_matrix& part, complex guess) {
  Eigen::SparseMatrix<complex> shifted = part.cast<complex>();
  const complex shift = guess + 1e-7 * std::abs(guess);
  for (int i = 0; i < shifted.rows(); ++i) shifted.coeffRef(i, i) -= shift;
  shifted.makeCompressed();
  const Eigen::SparseLU<Eigen::SparseMatrix<complex>> lu(shifted);
  Eigen::VectorXcd v = Eigen::VectorXcd::Ones(part.rows()).normalized();
  complex value = guess;
  for (int k = 0; k < 30; ++k) {
    const Eigen::VectorXcd w = lu.solve(v);
    const complex found = shift + 1.0 / v.dot(w);
    v = w.normalized();
    if (std::abs(found - std::exchange(value, found)) <= 1e-15 * std::abs(found)) break;
  }
  return value;
}

struct slowest_mode {
  std::size_t block;
  complex rate;
};

slowest_mode slowest_of(const std::vector<sparse_matrix>& parts) {
  slowest_mode least{0, -infinity};
  for (std::size_t b = 0; b < parts.size(); ++b)
    if (const complex rate = slowest_dense(parts[b]); rate.real() > least.rate.real()) least = {b, rate};
  return least;
}

Eigen::Index largest(const std::vector<sparse_matrix>& parts) {
  return std::ranges::max(parts, {}, [](const sparse_matrix& part) { return part.rows(); }).rows();
}

// By modulus: where the degree is too low for weak noise, eigenvalues stray to the right, but not to zero.
bool law_is_unique(const sphere_problem& problem) {
  return std::ranges::all_of(relaxing_blocks(problem, degrees[0]), [&](const sparse_matrix& part) {
    const Eigen::VectorXcd all = Eigen::EigenSolver<Eigen::MatrixXd>(Eigen::MatrixXd(part), false).eigenvalues();
    return all.cwiseAbs().minCoeff() > conserved * problem.covariance.norm();
  });
}

}  // namespace

stationary_law stationary(const sphere_problem& problem, double tolerance, int wanted) {
  if (problem.covariance.isZero(0))
    return {.reason = "no noise: every attractor carries a stationary law, and none has a density"};
  if (!law_is_unique(problem)) return {.reason = "not unique: a function besides the Casimir is conserved"};
  stationary_law last;
  for (const int degree : degrees_to_try(degrees, wanted)) {
    auto density = left_null_vector(backward_operator(problem, degree), most_sparse);
    if (!density) break;
    *density /= std::sqrt(4 * std::numbers::pi);  // integral one
    Eigen::VectorXd change = *density;
    if (last.density) change.head(last.density->size()) -= *last.density;
    const double floor = 1e-15 * density->norm(), distance = std::max(change.norm(), floor);
    last = {.density = std::move(density), .change = change, .uncertainty = distance, .degree = degree, .reason = {}};
    if (last.uncertainty <= std::max(tolerance, 10 * floor)) return last;
  }
  last.reason = not_converged(tolerance, last.degree, needed_degree(problem));
  return last;
}

reference_value spectral_gap(const sphere_problem& problem, double tolerance, int wanted) {
  if (problem.covariance.isZero(0)) return {.reason = "no noise: nothing relaxes in law"};
  slowest_mode mode{0, -infinity};
  double change = infinity;
  const auto gap_at = [&](int degree) -> std::optional<projected_value> {
    const auto parts = relaxing_blocks(problem, degree);
    const complex before = mode.rate;
    if (largest(parts) <= most_dense)
      mode = slowest_of(parts);
    else if (largest(parts) <= most_sparse && change < -resolved * mode.rate.real())
      mode.rate = next_to(parts[mode.block], mode.rate);
    else
      return {};
    change = std::fabs(mode.rate.real() - before.real());
    return projected_value{-mode.rate.real(), 1e-14};
  };
  auto gap = raise_degree(degrees_to_try(degrees, wanted), tolerance, needed_degree(problem), gap_at);
  if (gap.value.value_or(1) > 0) return gap;
  gap.uncertainty = std::max(gap.uncertainty, -*gap.value);  // the degree is too low for noise so weak, or rounding
  if (gap.uncertainty > std::max(tolerance, 1e-14))
    gap.reason = not_converged(tolerance, gap.degree, needed_degree(problem));
  gap.value = 0;
  return gap;
}

}  // namespace polhode
