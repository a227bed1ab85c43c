// SPDX-License-Identifier: Apache-2.0
#include "algebra/banded_solve.hpp"

#include <algorithm>
#include <ranges>

#include "algebra/dense_algebra.hpp"

namespace polhode {
namespace {

/// The largest index that each one is coupled with, either way.
std::vector<int> reaches(const sparse_matrix& a) {
  std::vector<int> out(static_cast<std::size_t>(a.cols()));
  for (int column = 0; column < a.cols(); ++column) out[static_cast<std::size_t>(column)] = column;
  for (int column = 0; column < a.cols(); ++column)
    for (sparse_matrix::InnerIterator entry(a, column); entry; ++entry) {
      auto& lower = out[static_cast<std::size_t>(std::min(column, int(entry.row())))];
      lower = std::max(lower, std::max(column, int(entry.row())));
    }
  return out;
}

/// Where each run of indices ends: a run holds all that the one before is coupled with.
std::vector<int> ends_of_runs(const sparse_matrix& a) {
  const auto reach = reaches(a);
  std::vector<int> ends;
  for (int start = 0, end = 1; start < a.cols();) {
    ends.push_back(end);
    const int last = *std::max_element(reach.begin() + start, reach.begin() + end);
    start = end;
    end = std::min(std::max(last + 1, start + 1), int(a.cols()));
  }
  return ends;
}

}  // namespace

std::optional<Eigen::VectorXd> banded_solve(const sparse_matrix& a, const Eigen::VectorXd& right) {
  // Forwards: the unknowns of a run are column 0 less the others times the unknowns of the next run.
  std::vector<Eigen::MatrixXd> eliminated;
  const auto ends = ends_of_runs(a);
  int before = 0, start = 0;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const int size = ends[k] - start, next = k + 1 < ends.size() ? ends[k + 1] - ends[k] : 0;
    Eigen::MatrixXd diagonal = a.block(start, start, size, size);
    Eigen::MatrixXd sides(size, 1 + next);
    sides << right.segment(start, size), Eigen::MatrixXd(a.block(start, ends[k], size, next));
    if (k > 0) {
      const Eigen::MatrixXd back = -Eigen::MatrixXd(a.block(start, before, size, start - before));
      const auto& known = eliminated.back();
      add_product(back, known.rightCols(size), diagonal);
      add_product(back, known.col(0), sides.col(0));
    }
    eliminated.push_back(solution_of(diagonal, sides));
    before = start;
    start = ends[k];
  }
  Eigen::VectorXd x(a.cols());
  Eigen::Index at = a.cols(), next = 0;
  for (const auto& known : std::views::reverse(eliminated)) {
    const Eigen::VectorXd later = x.segment(at, next);
    at -= known.rows();
    x.segment(at, known.rows()) = known.col(0) - known.rightCols(next) * later;
    next = known.rows();
  }
  if (!x.allFinite()) return std::nullopt;
  return x;
}

}  // namespace polhode
