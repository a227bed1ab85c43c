// SPDX-License-Identifier: Apache-2.0
#include "experiments/laws/difference_bar.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/decompositions.hpp"
#include "algebra/dense_algebra.hpp"
#include "algebra/sparse_blocks.hpp"

namespace polhode {
namespace {

constexpr int apart = 4;  // degrees between the two
constexpr int least = 4;  // of h^2

int degree_of(Eigen::Index count) { return static_cast<int>(std::lround(std::sqrt(static_cast<double>(count)))) - 1; }

/// |v_l|, l = 0, 1, …: they do not depend on the axes.
Eigen::VectorXd by_degree(const Eigen::VectorXd& v) {
  Eigen::VectorXd out(degree_of(v.size()) + 1);
  for (int l = 0; l < out.size(); ++l) out[l] = v.segment(harmonic_index(l, -l), 2 * l + 1).norm();
  return out;
}

}  // namespace

int lower_degree(int degree) { return std::max(std::min(least, degree), degree - apart); }

projected_generator project_generator(const sparse_matrix& generator, const Eigen::MatrixXd& functions) {
  const int n = harmonic_count(lower_degree(degree_of(generator.cols())));
  projected_generator out{{}, functions};
  const auto law = left_null_vector(generator, static_cast<int>(generator.cols()));
  Eigen::SparseLU<sparse_matrix> lu(sparse_matrix(generator.block(1, 1, n - 1, n - 1)));
  if (!law || lu.info() != Eigen::Success) return out;
  out.law = law->transpose() / unit_of_mean;
  const Eigen::MatrixXd right = functions.middleRows(1, n - 1), v = lu.solve(right);
  out.remainder -= generator.middleCols(1, n - 1) * v;
  out.remainder.topRows(n).setZero();
  return out;
}

Eigen::VectorXd difference_bar(const Eigen::MatrixXd& step, const Eigen::RowVectorXd& law,
                               const projected_generator& generator, const Eigen::MatrixXd& functions) {
  const int n = harmonic_count(lower_degree(degree_of(step.cols())));
  const Eigen::MatrixXd change = step.block(1, 1, n - 1, n - 1) - Eigen::MatrixXd::Identity(n - 1, n - 1);
  const Eigen::MatrixXd u = solution_of(change, functions.middleRows(1, n - 1));
  Eigen::MatrixXd remainder = functions;
  remainder.bottomRows(step.rows() - n) -= step.block(n, 1, step.rows() - n, n - 1) * u;
  remainder.topRows(n).setZero();
  const Eigen::VectorXd own = by_degree(law.transpose()), off = by_degree((law - generator.law).transpose());
  Eigen::VectorXd out(functions.cols());
  for (Eigen::Index k = 0; k < out.size(); ++k)
    out[k] = by_degree(generator.remainder.col(k)).dot(off) +
             by_degree(remainder.col(k) - generator.remainder.col(k)).dot(own);
  return out;
}

}  // namespace polhode
