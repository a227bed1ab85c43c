// SPDX-License-Identifier: Apache-2.0
#include "transfer/basis/frame_basis.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "algebra/dense_algebra.hpp"
#include "transfer/basis_sums.hpp"
#include "transfer/frame_sums.hpp"
#include "transfer/points/point_block.hpp"
#include "transfer/points/turned_quadrature.hpp"

namespace polhode {
namespace {

using std::numbers::pi;

double square(double x) { return x * x; }

/// sqrt((2l)! / ((l+k)! (l-k)!)), l >= k >= 0.
double binomial_root(int l, int k) {
  double ratio = 1;
  for (int i = 1; i <= l - k; ++i) ratio *= static_cast<double>(l + k + i) / i;
  return std::sqrt(ratio);
}

/// <l-1 mn| cos(beta) |l mn> of normalised functions.
double step_down(int l, int m, int n) {
  return std::sqrt((square(l) - square(m)) * (square(l) - square(n)) / (4 * square(l) - 1)) / l;
}

void add_recurrence(int degree, int m, int n, std::vector<double>& out) {
  const int least = std::max(std::abs(m), n);
  out.push_back(binomial_root(least, std::min(std::abs(m), n)) * std::sqrt(2 * least + 1.0) *
                (m == 0 && n == 0 ? 1 : std::numbers::sqrt2));
  for (int l = least; l <= degree; ++l) {
    const double up = step_down(l + 1, m, n), inside = l > 0 ? double(m) * n / (double(l) * (l + 1)) : 0;
    for (const double factor : {1.0, -inside, l > least ? step_down(l, m, n) : 0}) out.push_back(factor / up);
  }
}

void add_turn(double angle, std::vector<double>& out) {
  out.push_back(std::cos(angle));
  out.push_back(std::sin(angle));
}

/// Unit vectors at right angles to those.
points_on_sphere tangents_at(const points_on_sphere& x) {
  points_on_sphere v(x.rows(), 3);
  for (Eigen::Index i = 0; i < x.rows(); ++i) v.row(i) = x.row(i).transpose().unitOrthogonal().transpose();
  return v;
}

points_on_sphere crossed(const points_on_sphere& x, const points_on_sphere& v) {
  points_on_sphere w(x.rows(), 3);
  for (Eigen::Index i = 0; i < x.rows(); ++i) w.row(i) = x.row(i).cross(v.row(i));
  return w;
}

}  // namespace

frame_basis::frame_basis(int degree, functions which) : degree_(degree), which_(which), first_{0} {
  list_functions();
  for (int i = 0; i < angles(); ++i) add_turn(angle(i), turns_);
  const auto rule = turned_quadrature(2 * degree);
  const bool all = which == functions::all;
  const auto count = all ? rule.weights.size() : rule.weights.size() / 4;
  points_ = rule.points.topRows(count);
  v_ = tangents_at(points_);
  w_ = crossed(points_, v_);
  make_duals((all ? 1 : 4) / (4 * pi) * rule.weights.head(count));
}

void frame_basis::list_functions() {
  const int most = degree_ - degree_ % m_step();
  for (int n = 0; n <= degree_; n += 2) {
    const auto parts = [&](int m) { return m == 0 && n == 0 ? 1 : 2; };
    std::vector<int> at(static_cast<std::size_t>(2 * most + 1));  // [m + most]: the first of that m
    for (int m = n == 0 ? 0 : -most; m <= most; m += m_step()) {
      add_recurrence(degree_, m, n, recurrence_);
      at[static_cast<std::size_t>(m + most)] = summed_;
      summed_ += parts(m) * (degree_ + 1 - std::max(std::abs(m), n));
    }
    for (int m = n == 0 || which_ == functions::invariant ? 0 : -most; m <= most; m += m_step()) {
      const int least = std::max(std::abs(m), n), mirrored = n == 0 ? m : -m;
      for (int l = least; l <= degree_; ++l)
        for (int part = 0; part < parts(m); ++part) {
          const auto place = [&](int of) {
            return at[static_cast<std::size_t>(of + most)] + parts(m) * (l - least) + part;
          };
          const double sign = ((l - least) % 2 == 0) != (n == 0 && part == 1) ? 1 : -1;
          if (which_ == functions::all)
            combinations_.push_back({place(m), place(m), 1, 0});
          else if (mirrored != m)
            combinations_.push_back({place(m), place(mirrored), 1 / std::numbers::sqrt2, sign});
          else if (sign > 0)
            combinations_.push_back({place(m), place(m), 1, 0});
        }
    }
    first_.push_back(static_cast<int>(combinations_.size()));
  }
}

Eigen::MatrixXd frame_basis::combined(const Eigen::MatrixXd& values) const {
  Eigen::MatrixXd out(values.rows(), size());
  Eigen::Index i = 0;
  for (const auto& c : combinations_) {
    out.col(i) = c.scale * values.col(c.one);
    if (c.sign != 0) out.col(i) += c.scale * c.sign * values.col(c.other);
    ++i;
  }
  return out;
}

double frame_basis::angle(int i) const { return pi * i / angles(); }

void frame_basis::make_duals(const Eigen::VectorXd& weights) {
  std::vector<double> turns;
  add_turn(0, turns);
  for (int n = 2; n <= degree_; n += 2) add_turn(pi / (2 * n), turns);
  const auto columns = [&](const Eigen::MatrixXd& all, std::size_t k) {
    return all.middleCols(first_[k], first_[k + 1] - first_[k]);
  };
  for (std::size_t k = 0; k + 1 < first_.size(); ++k)
    for (auto& dual : duals_.emplace_back()) dual.resize(points_.rows(), first_[k + 1] - first_[k]);
  frame_means means(*this, turns);
  std::array<double, 3 * block_lanes> states;
  std::array<double, 6 * block_lanes> tangents;
  const double one = 1;
  for (int first = 0; first < points_.rows(); first += block_lanes) {
    const int count = lanes_in_use(points_, first);
    load_block(points_, first, states.data());
    load_block(v_, first, tangents.data());
    load_block(w_, first, tangents.data() + states.size());
    means.clear();
    means.add(count, {&one, 1}, states.data(), tangents.data());
    const auto some = weights.segment(first, count).asDiagonal();
    const auto at_0 = means.functions(0, count);
    for (std::size_t k = 0; k < duals_.size(); ++k) {
      duals_[k][0].middleRows(first, count) = some * columns(at_0, k);
      const auto at_quarter = means.functions(static_cast<int>(k), count);
      duals_[k][1].middleRows(first, count) = some * columns(at_quarter, k);
    }
  }
}

void frame_basis::add_coefficients(int first, const std::vector<Eigen::MatrixXd>& values, Eigen::MatrixXd& out) const {
  const auto points = values[0].rows();
  for (std::size_t k = 0; k < duals_.size(); ++k) {
    const double n = 2 * static_cast<double>(k);
    Eigen::MatrixXd cosine = Eigen::MatrixXd::Zero(points, values[0].cols()), sine = cosine;
    for (int i = 0; i < angles(); ++i) {
      cosine += std::cos(n * angle(i)) / angles() * values[static_cast<std::size_t>(i)];
      if (k > 0) sine += std::sin(n * angle(i)) / angles() * values[static_cast<std::size_t>(i)];
    }
    auto rows = out.middleRows(first_[k], first_[k + 1] - first_[k]);
    add_transposed_product(duals_[k][0].middleRows(first, points), cosine, rows);
    if (k > 0) add_transposed_product(duals_[k][1].middleRows(first, points), sine, rows);
  }
}

frame_means::frame_means(const frame_basis& basis, std::span<const double> turns) : basis_(basis), turns_(turns) {
  const auto angles = turns.size() / 2;
  sums_.resize(block_lanes * angles * static_cast<std::size_t>(basis.summed()));
  growth_.resize(block_lanes * angles);
}

void frame_means::clear() {
  std::ranges::fill(sums_, 0.0);
  std::ranges::fill(growth_, 0.0);
}

void frame_means::add(int lanes, std::span<const double> weights, const double* states, const double* tangents) {
  add_frames({basis_.degree(), basis_.m_step(), basis_.recurrence().data(), basis_.summed(),
              static_cast<int>(turns_.size() / 2), turns_.data(), lanes, static_cast<int>(weights.size()),
              weights.data(), states, tangents, sums_.data(), growth_.data()});
}

Eigen::MatrixXd frame_means::functions(int angle, int points) const {
  using lanes = Eigen::Map<const Eigen::Matrix<double, sum_lanes, Eigen::Dynamic>>;
  const int angles = static_cast<int>(turns_.size() / 2), size = basis_.summed();
  Eigen::MatrixXd out(points, size);
  for (int first = 0; first < points; first += sum_lanes) {
    const int rows = std::min(sum_lanes, points - first);
    const auto* at = sums_.data() + static_cast<std::ptrdiff_t>(first / sum_lanes * angles + angle) * size * sum_lanes;
    out.middleRows(first, rows) = lanes(at, sum_lanes, size).topRows(rows);
  }
  return basis_.combined(out);
}

Eigen::VectorXd frame_means::growth(int angle, int points) const {
  return Eigen::Map<const Eigen::VectorXd>(growth_.data() + angle * block_lanes, points);
}

}  // namespace polhode
