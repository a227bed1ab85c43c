// SPDX-License-Identifier: Apache-2.0
#include "transfer/points/turned_quadrature.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "algebra/dense_algebra.hpp"

namespace polhode {
namespace {

/// [point][m + degree], m < 0 the sines: on a ring above the equator and on its image below.
struct ring_waves {
  Eigen::MatrixXd north, south;
};

ring_waves waves_on_rings(int half, int degree) {
  Eigen::MatrixXd north(2 * half, 2 * degree + 1), south = north;
  for (int k = 0; k < 2 * half; ++k)
    for (int m = -degree; m <= degree; ++m) {
      const double turn = std::numbers::pi * (m * k % (2 * half)) / half,
                   mirrored = m * (k < half ? 0 : 1) % 2 == 0 ? 1 : -1;
      north(k, m + degree) = m < 0 ? -std::sin(turn) : std::cos(turn);
      // At -phi, and from half a ring on at pi - phi, phi less the half ring.
      const double back = std::numbers::pi * (m * (k % half)) / half;
      south(k, m + degree) = mirrored * (m < 0 ? std::sin(back) : std::cos(back));
    }
  return {std::move(north), std::move(south)};
}

}  // namespace

sphere_rule turned_quadrature(int degree) {
  while (degree % 4 != 3) ++degree;  // no ring on the equator, and an even number of points on each
  const auto all = sphere_quadrature(degree);
  const auto count = all.weights.size() / 4;
  sphere_rule out{points_on_sphere(4 * count, 3), Eigen::VectorXd(4 * count), 0};
  for (Eigen::Index i = 0, quarter = 0; i < all.weights.size(); ++i) {
    if (all.points(i, 2) < 0 || i % all.per_ring >= all.per_ring / 2) continue;
    for (Eigen::Index turn = 0; turn < 4; ++turn) {
      out.points.row(turn * count + quarter) = all.points.row(i).cwiseProduct(half_turns.row(turn));
      out.weights[turn * count + quarter] = all.weights[i];
    }
    ++quarter;
  }
  return out;
}

void add_by_rings(const Eigen::MatrixXd& duals, int degree, const Eigen::Ref<const Eigen::MatrixXd>& values,
                  Eigen::MatrixXd& part) {
  constexpr Eigen::Index most_columns = 256;  // at a time
  const auto count = duals.rows() / 4;
  const int half = static_cast<int>(std::lround(std::sqrt(2.0 * static_cast<double>(count))));  // of a ring
  const Eigen::Index above = count / half;
  const auto [north, south] = waves_on_rings(half, degree);
  for (Eigen::Index from = 0; from < values.cols(); from += most_columns) {
    const auto columns = std::min(most_columns, values.cols() - from);
    std::vector<Eigen::MatrixXd> along(static_cast<std::size_t>(2 * degree + 1), Eigen::MatrixXd(2 * above, columns));
    Eigen::MatrixXd ring(2 * half, columns), waves(2 * degree + 1, columns);
    for (Eigen::Index r = 0; r < 2 * above; ++r) {
      const auto first = (r < above ? 0 : 2) * count + r % above * half;
      ring << values.block(first, from, half, columns), values.block(first + count, from, half, columns);
      waves.setZero();
      add_transposed_product(r < above ? north : south, ring, waves);
      for (std::size_t m = 0; m < along.size(); ++m) along[m].row(r) = waves.row(static_cast<Eigen::Index>(m));
    }
    for (int m = -degree; m <= degree; ++m) {
      std::vector<int> rows, heights;  // of Y_lm; of Y_l|m|, the cosine, which is its height's part at longitude 0
      for (int l = std::abs(m); l <= degree; ++l) {
        rows.push_back(harmonic_index(l, m));
        heights.push_back(harmonic_index(l, std::abs(m)));
      }
      Eigen::MatrixXd height(2 * above, static_cast<Eigen::Index>(rows.size()));
      for (Eigen::Index r = 0; r < 2 * above; ++r)
        height.row(r) = duals(Eigen::seqN((r < above ? 0 : 2) * count + r % above * half, 1), heights);
      Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(height.cols(), columns);
      add_transposed_product(height, along[static_cast<std::size_t>(m + degree)], sum);
      part(rows, Eigen::seqN(from, columns)) += sum;
    }
  }
}

}  // namespace polhode
