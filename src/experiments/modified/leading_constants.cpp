// SPDX-License-Identifier: Apache-2.0
#include "experiments/modified/leading_constants.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <limits>

#include "algebra/decompositions.hpp"
#include "algebra/exponential_action.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/laws/true_law.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/harmonics.hpp"
#include "statistics/orders/power_series.hpp"

namespace polhode {
namespace {

constexpr int margin = 8;           // degrees around a corner: what leaves it and comes back is of order dt^5 there
constexpr double panel_length = 1;  // of the integral over time, in fastest time scales
constexpr transfer_rule one_step{{0, 1, 0}, {5, 2}};

using gauss = boost::math::quadrature::gauss<double, 10>;

/// The upper left corner of exp(t L), L on harmonics up to a higher degree, by Taylor's series.
Eigen::MatrixXd corner_of_exponential(const sphere_problem& p, int degree, double t) {
  const sparse_matrix generator = t * backward_operator(p, degree + margin);
  const auto n = harmonic_count(degree);
  Eigen::MatrixXd term = Eigen::MatrixXd::Identity(generator.rows(), n), sum = term.topRows(n);
  for (int k = 1; k < 200; ++k) {
    term = generator * term / k;
    sum += term.topRows(n);
    if (term.cwiseAbs().maxCoeff() < 1e-18) break;
  }
  return sum;
}

/// Times 0 <= s <= T and weights.
struct time_rule {
  std::vector<double> at, weight;
  time_rule(double horizon, double rate) {
    const int panels = std::max(2, static_cast<int>(std::ceil(horizon * rate / panel_length)));
    const double half = horizon / panels / 2;
    for (int i = 0; i < panels; ++i) {
      const double middle = (2 * i + 1) * half;
      for (std::size_t k = gauss::abscissa().size(); k-- > 0;)
        add(middle - half * gauss::abscissa()[k], half * gauss::weights()[k]);
      for (std::size_t k = 0; k < gauss::abscissa().size(); ++k)
        add(middle + half * gauss::abscissa()[k], half * gauss::weights()[k]);
    }
  }

 private:
  void add(double s, double w) {
    at.push_back(s);
    weight.push_back(w);
  }
};

Eigen::MatrixXd coefficients(const exact_averages& averages, double radius, int degree) {
  Eigen::MatrixXd out(harmonic_count(degree), averages.count());
  for (Eigen::Index i = 0; i < averages.count(); ++i) {
    const auto& f = averages.functions[static_cast<std::size_t>(i)];
    out.col(i) = harmonic_coefficients([&](const Eigen::Vector3d& x) { return f(radius * x); }, degree);
  }
  return out;
}

/// L u = f - pi(f), u without its mean.
Eigen::MatrixXd poisson_solutions(const sparse_matrix& generator, const Eigen::MatrixXd& f) {
  const auto n = generator.rows() - 1;
  const sparse_matrix relaxing = generator.bottomRightCorner(n, n);
  const Eigen::SparseLU<sparse_matrix> lu(relaxing);
  Eigen::MatrixXd u = Eigen::MatrixXd::Zero(n + 1, f.cols());
  for (Eigen::Index i = 0; i < f.cols(); ++i) u.col(i).tail(n) = lu.solve(Eigen::VectorXd(f.col(i).tail(n)));
  return u;
}

}  // namespace

expansion_frame::expansion_frame(const subject& s, const law_averages& averages, int degree, std::vector<double> dt)
    : degree_(degree), dt_(std::move(dt)) {
  const auto p = *s.sphere();
  const sparse_matrix generator = backward_operator(p, degree), forward = generator.transpose();
  for (const double t : dt_) exact_step_.push_back(corner_of_exponential(p, degree, t));
  const time_rule times(s.scene.horizon, fastest_rate(s));
  const auto count = times.at.size();
  weight_ = Eigen::Map<const Eigen::VectorXd>(times.weight.data(), static_cast<Eigen::Index>(count));
  before_.resize(static_cast<Eigen::Index>(count), generator.rows());
  after_.resize(count);
  Eigen::VectorXd law = harmonics_at(Eigen::Vector3d(s.scene.momentum.data()).normalized(), degree);
  for (std::size_t k = 0; k < count; ++k) {
    law = exponential_action(forward, times.at[k] - (k == 0 ? 0 : times.at[k - 1]), law);
    before_.row(static_cast<Eigen::Index>(k)) = law;
  }
  Eigen::MatrixXd f = coefficients(averages.at_horizon, p.radius, degree);
  for (std::size_t k = count; k-- > 0;) {
    const double step = (k + 1 == count ? s.scene.horizon : times.at[k + 1]) - times.at[k];
    for (Eigen::Index i = 0; i < f.cols(); ++i) f.col(i) = exponential_action(generator, step, f.col(i));
    after_[k] = f;
  }
  if (averages.stationary.count() == 0) return;
  const Eigen::VectorXd density = *true_law(s).density;
  law_ = Eigen::RowVectorXd::Zero(generator.rows());
  const auto both = std::min(density.size(), law_.size());
  law_.head(both) = density.head(both);
  poisson_ = poisson_solutions(generator, coefficients(averages.stationary, p.radius, degree));
}

Eigen::VectorXd expansion_frame::constants(const Eigen::MatrixXd& step, std::size_t level, int order) const {
  const Eigen::MatrixXd first = (step - exact_step_[level]) / std::pow(dt_[level], order + 1);
  const auto horizon = after_.empty() ? 0 : after_.front().cols();
  Eigen::VectorXd out = Eigen::VectorXd::Zero(horizon + poisson_.cols());
  const Eigen::MatrixXd flux = before_ * first;
  for (std::size_t k = 0; k < after_.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(k);
    out.head(horizon) += weight_[row] * (flux.row(row) * after_[k]).transpose();
  }
  if (poisson_.cols() > 0) out.tail(poisson_.cols()) = -(law_ * first * poisson_).transpose();
  return out;
}

std::vector<interval_estimate> predicted_constants(const subject& s, const scheme_entry& scheme,
                                                   const law_averages& averages, const expansion_frame& coarse,
                                                   const expansion_frame& fine, int order) {
  std::vector<Eigen::VectorXd> found, lower;
  for (std::size_t level = 0; level < fine.dt().size(); ++level) {
    auto rule = one_step;
    rule.basis.degree = fine.degree();
    const auto step = make_transfer(s, scheme, fine.dt()[level], 1, rule).matrix;
    const auto corner = harmonic_count(coarse.degree());
    found.push_back(fine.constants(step, level, order));
    lower.push_back(coarse.constants(step.topLeftCorner(corner, corner), level, order));
  }
  // Two degrees may agree by accident: the averages lend each other their change.
  const Eigen::VectorXd size = averages.size(), change = (found.back() - lower.back()).cwiseAbs();
  const double largest = change.size() > 0 ? change.cwiseQuotient(size).maxCoeff() : 0;
  std::vector<interval_estimate> out;
  for (Eigen::Index i = 0; i < change.size(); ++i) {
    std::vector<double> value;
    for (const auto& level : found) value.push_back(level[i]);
    const auto c = series_by_all_levels(fine.dt(), value, std::vector<double>(value.size(), 0.0), 1).front();
    const double truncated = 3 * std::max(change[i], largest * size[i] / 3);
    out.push_back({c.value, c.low - truncated, c.high + truncated});
  }
  return out;
}

}  // namespace polhode
