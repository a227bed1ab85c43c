#include "experiments/ergodic_variance.hpp"

#include <fmt/format.h>

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ensemble/dense_algebra.hpp"
#include "experiments/stationary_bias.hpp"
#include "statistics/power_series.hpp"

namespace polhode {
namespace {

constexpr int least_degree = 16, more_degrees = 8;
constexpr double rounding = 1e-15;  // of a function: what another symmetry has of it
constexpr double narrow = 1e-3;     // half-width, of the variance at the coarsest dt

/// int law a b over the sphere, all three in harmonics.
class triple_product {
 public:
  explicit triple_product(int degree)
      : rule_(sphere_quadrature(2 * degree + 2)), values_(harmonics(rule_.points, degree)) {}
  double operator()(const Eigen::VectorXd& law, const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    const auto at = [&](const Eigen::VectorXd& f) { return (values_.leftCols(f.size()) * f).array().eval(); };
    return (rule_.weights.array() * at(law) * at(a) * at(b)).sum();
  }

 private:
  sphere_rule rule_;
  Eigen::MatrixXd values_;
};

/// f less its mean under the law.
Eigen::VectorXd centred(Eigen::VectorXd f, const Eigen::VectorXd& law) {
  f[0] -= law.dot(f) / law[0];
  return f;
}

Eigen::VectorXd of_equation(const sphere_problem& p, const Eigen::VectorXd& density, const exact_averages& averages,
                            int degree) {
  const sparse_matrix generator = backward_operator(p, degree);
  const auto n = generator.rows() - 1;
  const sparse_matrix relaxing = generator.bottomRightCorner(n, n);
  const Eigen::SparseLU<sparse_matrix> lu(relaxing);
  const triple_product integral(degree);
  Eigen::VectorXd law = Eigen::VectorXd::Zero(n + 1), out(averages.count());
  const auto both = std::min(law.size(), density.size());
  law.head(both) = density.head(both);
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    const auto& f = averages.functions[static_cast<std::size_t>(i)];
    const auto g =
        centred(harmonic_coefficients([&](const Eigen::Vector3d& x) { return f(p.radius * x); }, degree), law);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(n + 1);
    u.tail(n) = lu.solve(Eigen::VectorXd(g.tail(n)));
    out[i] = -2 * integral(law, g, u);
  }
  return out;
}

/// w with (1 - T) w = g, g and w without the constant.
Eigen::VectorXd relaxed(const transfer_operator& op, const Eigen::VectorXd& g) {
  Eigen::VectorXd w = Eigen::VectorXd::Zero(g.size());
  for (auto block : op.blocks) {
    std::erase(block, 0);
    const Eigen::RowVectorXd right = g(block).transpose();
    if (right.norm() <= rounding * g.norm()) continue;
    const Eigen::MatrixXd step = op.matrix(block, block),
                          relaxing = (Eigen::MatrixXd::Identity(step.rows(), step.cols()) - step).transpose();
    w(block) = solve_from_left(relaxing, right).transpose();
  }
  return w;
}

report::verdict judge(const exact_averages& averages, const error_table& t, Eigen::Index first, int order) {
  report::verdict v{"modified", t.scheme, variance_claim, 0.0, {}, {}, {}, report::verdict_kind::inconclusive, ""};
  if (t.dt.size() < static_cast<std::size_t>(order) + 2) {
    v.reason = "too few step sizes";
    return v;
  }
  double widest = 0, clearest = 0;
  for (Eigen::Index i = 0; i < averages.count(); ++i) {
    std::vector<double> value, uncertainty;
    for (std::size_t level = 0; level < t.dt.size(); ++level) {
      value.push_back(t.error[level][first + i] / averages.value[i]);
      uncertainty.push_back(t.uncertainty[level][first + i] / averages.value[i]);
    }
    const auto series = series_coefficients(t.dt, value, uncertainty, static_cast<std::size_t>(order));
    for (std::size_t power = 0; power < series.size(); ++power) {
      const double unit = std::pow(std::ranges::max(t.dt), static_cast<double>(power));
      const double half = unit * (series[power].high - series[power].low) / 2, at = unit * series[power].value;
      const double clear = std::fabs(at) / std::max(half, 1e-300);
      if (clear > 1 ? clear <= clearest : clearest > 1 || half <= widest) continue;
      (clear > 1 ? clearest : widest) = clear > 1 ? clear : half;
      v.estimate = at;
      v.low = at - half;
      v.high = at + half;
      v.reason = fmt::format("of {} at order dt^{}: {:.2e} [{:.1e}, {:.1e}] of its size",
                             averages.names[static_cast<std::size_t>(i)], power, at, at - half, at + half);
    }
  }
  v.kind = clearest > 1       ? report::verdict_kind::refuted
           : widest <= narrow ? report::verdict_kind::holds
                              : report::verdict_kind::inconclusive;
  return v;
}

}  // namespace

exact_averages ergodic_variances(const subject& s, const law_averages& averages) {
  exact_averages out = averages.stationary;
  if (out.count() == 0) return out;
  const auto p = *sphere_problem_of(s);
  const auto law = true_law(s);
  const int degree = std::max(least_degree, law.degree);
  const Eigen::VectorXd before = of_equation(p, *law.density, averages.stationary, degree);
  out.value = of_equation(p, *law.density, averages.stationary, degree + more_degrees);
  out.uncertainty = 3 * (out.value - before).cwiseAbs() + 1e-13 * out.value;
  out.size = out.value;
  return out;
}

Eigen::VectorXd ergodic_variances(const exact_averages& averages, const transfer_operator& op, double dt) {
  Eigen::VectorXd out(averages.count());
  if (out.size() == 0) return out;
  const Eigen::VectorXd law = op.stationary_law().transpose();
  const triple_product integral(op.basis.degree());
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    const auto g = centred(op.basis.coefficients(averages.functions[static_cast<std::size_t>(i)]), law);
    const Eigen::VectorXd w = relaxed(op, g);
    out[i] = dt * (2 * integral(law, g, w) - integral(law, g, g));
  }
  return out;
}

void report_ergodic_variances(const exact_averages& averages, const error_table& t, Eigen::Index first, int order,
                              report::results& out) {
  if (averages.count() == 0) return;
  for (Eigen::Index i = 0; i < averages.count(); ++i) {
    const auto& name = averages.names[static_cast<std::size_t>(i)];
    std::vector<report::measurement> points;
    std::vector<double> clear;
    const series s{"modified", t.scheme, "error of the asymptotic variance", name, "", "transfer"};
    for (std::size_t level = 0; level < t.dt.size(); ++level) {
      const double error = std::fabs(t.error[level][first + i]), u = t.uncertainty[level][first + i];
      points.push_back(measured(s, t.dt[level], error, std::max(0.0, error - u), error + u));
      clear.push_back(error > 50 * u ? error : std::numeric_limits<double>::quiet_NaN());
    }
    record_fit(out, s, fit_order(t.dt, clear, 0), std::move(points));
  }
  out.verdicts.push_back(judge(averages, t, first, order));
}

}  // namespace polhode
