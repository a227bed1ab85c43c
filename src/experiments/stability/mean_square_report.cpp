// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability/mean_square_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "algebra/decompositions.hpp"
#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "problem/subject.hpp"
#include "problem/vectors.hpp"
#include "sphere/closed_forms/linearised.hpp"
#include "sphere/equilibria.hpp"
#include "sphere/sphere_problem.hpp"
#include "statistics/orders/order_fit.hpp"
#include "transfer/points/noise_nodes.hpp"

namespace polhode {
namespace {

// Do mean squares beside an equilibrium grow or shrink as those of the equation do?
//
// Where h is stationary the equation without noise stands still, and so does that with noise along the direction alone
// (sphere/closed_forms/linearised.hpp). One step of a scheme has the Jacobian J there, by dual numbers, and E[J x
// J], by Gauss-Hermite nodes of the noise, takes mean squares one step on: log of its spectral radius over dt is the
// scheme's own rate of growth. Nothing is sampled. As mean squares are expectations its error falls at the weak order
// for one noise vector.

/// An equilibrium that some noise acts along.
struct noisy_equilibrium {
  std::string name;  ///< "axis 1": in the order of the axes; in a field "equilibrium 1": in order of energy
  Eigen::Vector3d direction;
  double strength;  ///< of the noise along it
};

constexpr int nodes = 24;  // of the noise of a step

double strength_along(const report::scene& s, const Eigen::Vector3d& direction) {
  double square = 0;
  for (const auto& v : noise_vectors_of(s))
    square += std::pow(direction.dot(Eigen::Map<const Eigen::Vector3d>(v.data())), 2);
  return std::sqrt(square);
}

/// One step, every lane with the noise of a node: Jacobians in the plane across the direction.
struct noisy_jacobians {
  std::vector<Eigen::Matrix2d> at;
  std::vector<double> weight;
};

noisy_jacobians jacobians_of(const subject& s, const scheme_entry& scheme, const Eigen::Vector3d& direction,
                             double dt) {
  const auto rule = nodes_of(*s.model, scheme.needs_areas, dt, {nodes, 1});
  const auto layout = s.model->layout();
  const auto channels = static_cast<std::size_t>(layout.channels);
  std::vector<double> dw(layout.increments(1, block_lanes), 0.0), area(layout.areas(1, block_lanes), 0.0);
  for (std::size_t i = 0; i < rule.weight.size(); ++i)
    for (std::size_t k = 0; k < channels; ++k) dw[k * block_lanes + i] = rule.dw[i * channels + k];
  auto states = replicated(s.scene.momentum);
  std::vector<double> tangents(tangent_vectors * states.size(), 0.0);
  const auto frame = tangent_frame(direction);
  const auto entry = [&](int t, int k) -> double* {
    return tangents.data() + static_cast<std::size_t>(t) * states.size() + static_cast<std::size_t>(k) * block_lanes;
  };
  for (int t = 0; t < 2; ++t)
    for (int k = 0; k < 3; ++k) std::fill_n(entry(t, k), block_lanes, frame(k, t));
  scheme.tangent(dt)->advance(states, tangents, {1, dw, area});
  noisy_jacobians out{{}, rule.weight};
  for (std::size_t i = 0; i < rule.weight.size(); ++i) {
    Eigen::Matrix<double, 3, 2> moved;
    for (int t = 0; t < 2; ++t)
      for (int k = 0; k < 3; ++k) moved(k, t) = entry(t, k)[i];
    out.at.emplace_back(frame.transpose() * moved);
  }
  return out;
}

std::vector<noisy_equilibrium> noisy_equilibria(const subject& s) {
  const auto& p = *s.sphere();
  std::vector<noisy_equilibrium> out;
  if (!p.varying.empty()) return out;  // what is true there is not known
  const auto add = [&](const char* what, std::size_t number, const Eigen::Vector3d& direction) {
    const double strength = strength_along(s.scene, direction);
    if (strength > 0) out.push_back({fmt::format("{} {}", what, number), direction, strength});
  };
  if (p.has_field()) {
    const auto all = equilibria(p);
    for (std::size_t i = 0; i < all.size(); ++i) add("equilibrium", i + 1, all[i].direction);
    return out;
  }
  const Eigen::Matrix3d axes = principal_axes(p);
  for (Eigen::Index k = 0; k < 3; ++k) add("axis", static_cast<std::size_t>(k) + 1, axes.col(k));
  return out;
}

/// The scene with the momentum there and, of the noise, what acts along it.
report::scene beside(const report::scene& s, const noisy_equilibrium& e) {
  const auto times = [&](double x) {
    const Eigen::Vector3d v = x * e.direction;
    return std::vector<double>{v[0], v[1], v[2]};
  };
  auto out = with_noise_vectors(s, {times(e.strength)});
  out.momentum = times(length(s.momentum));
  return out;
}

/// Rate of growth of mean squares under steps of dt of the scheme, on a scene beside the equilibrium.
double own_mean_square_growth(const subject& beside, const scheme_entry& scheme, const Eigen::Vector3d& direction,
                              double dt) {
  const auto j = jacobians_of(beside, scheme, direction, dt);
  Eigen::Matrix4d squares = Eigen::Matrix4d::Zero();
  for (std::size_t i = 0; i < j.at.size(); ++i)
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) squares.block<2, 2>(2 * a, 2 * b) += j.weight[i] * j.at[i](a, b) * j.at[i];
  if (!squares.allFinite()) return std::nan("");
  return std::log(eigenvalues_of(squares).cwiseAbs().maxCoeff()) / dt;
}

/// The same of the equation.
double true_mean_square_growth(const sphere_problem& p, const noisy_equilibrium& e) {
  return mean_square_growth(linearised_about(p, e.direction, e.strength));
}

using report::verdict_kind;

constexpr int levels = 12;         // of the order: dt times the fastest rate from 1/4, halved
constexpr double neutral = 1e-11;  // rate of growth over the fastest rate: neither stable nor unstable
constexpr double longest = 8;      // dt times the fastest rate, from where agreement is looked for
constexpr int per_octave = 8;
constexpr const char* growth_quantity = "mean_square_growth";

/// One equilibrium of one scheme.
struct growth_finding {
  noisy_equilibrium at;
  double truth;
  std::optional<order_fit> fit;
  bool exact;                              ///< every error at rounding
  double agrees_to = 0, disagrees_at = 0;  ///< dt; 0: never
  std::vector<report::series_id> rows = {};
};

/// From short steps to long ones, up to the first at which scheme and equation disagree.
void find_agreement(const subject& s, const scheme_entry& scheme, double rate, growth_finding& out) {
  if (std::fabs(out.truth) <= neutral * rate) return;
  for (int i = 5 * per_octave; i >= 0; --i) {
    const double dt = longest / rate * std::exp2(-static_cast<double>(i) / per_octave);
    const double own = own_mean_square_growth(s, scheme, out.at.direction, dt);
    if (!(own * out.truth > 0)) {
      out.disagrees_at = dt;
      return;
    }
    out.agrees_to = dt;
  }
}

/// What rounding leaves of a rate: the logarithm of a radius known to some 16 units over dt.
double rounding_at(double dt) { return 16 * std::numeric_limits<double>::epsilon() / dt; }

/// Thirty times that, so that it does not bend a slope.
double floor_at(double dt) { return 30 * rounding_at(dt); }

growth_finding find(const subject& s, const scheme_entry& scheme, const noisy_equilibrium& e, recorder& record) {
  const double rate = fastest_rate(s);
  growth_finding found{e, true_mean_square_growth(*s.sphere(), e), {}, true};
  curve growth{{growth_quantity, e.name, "1/time", "transfer"}},
      error{{"mean_square_error", e.name, "1/time", "transfer"}};
  std::vector<double> dt, errors;
  for (int l = 0; l < levels; ++l) {
    dt.push_back(std::exp2(-2 - l) / rate);
    const double own = own_mean_square_growth(s, scheme, e.direction, dt.back());
    errors.push_back(std::fabs(own - found.truth));
    const double size = errors.back(), rounding = rounding_at(dt.back());
    growth.add(dt.back(), own, own - rounding, own + rounding);
    error.add(dt.back(), size, std::max(0.0, size - rounding), size + rounding);
    if (size <= floor_at(dt.back()))
      errors.back() = 0;
    else
      found.exact = false;
  }
  found.fit = fit_order(dt, errors, 0);
  found.rows = {record.series(growth), record.series(error, found.fit)};
  find_agreement(s, scheme, rate, found);
  if (found.agrees_to > 0)
    found.rows.push_back(record.value({"mean_square_agreement", e.name, "time", "transfer"}, found.agrees_to,
                                      found.agrees_to,
                                      found.disagrees_at > 0 ? std::optional(found.disagrees_at) : std::nullopt));
  return found;
}

report::verdict judge_growth(const scheme_entry& scheme, const growth_finding& f) {
  auto v = judge_order(scheme.info.weak_order.one_vector, f.fit, true);
  if (f.exact) {
    v.kind = verdict_kind::holds;
    v.reason = "exact on this scene";
  }
  v.reason = fmt::format("{}: rate {:.4g}, {}", f.at.name, f.truth, v.reason);
  if (f.agrees_to > 0)
    v.reason += fmt::format(", {} up to dt = {:.3g}", f.truth < 0 ? "stable" : "unstable", f.agrees_to);
  return v;
}

/// The worst of them, with what is said of each.
report::verdict worst_of(const std::vector<report::verdict>& all) {
  const auto badness = [](const report::verdict& v) {
    return v.kind == verdict_kind::refuted ? 2 : v.kind == verdict_kind::inconclusive ? 1 : 0;
  };
  auto worst = *std::ranges::max_element(all, {}, badness);
  std::vector<std::string> reasons;
  for (const auto& v : all) reasons.push_back(v.reason);
  worst.reason = fmt::format("{}", fmt::join(reasons, "; "));
  return worst;
}

}  // namespace

void report_true_growth(const subject& s, recorder& record) {
  for (const auto& e : noisy_equilibria(s))
    record.value({growth_quantity, e.name, "1/time", "exact"}, true_mean_square_growth(*s.sphere(), e));
}

void report_mean_square(const context& c, recorder& record) {
  std::vector<report::verdict> all;
  std::vector<report::series_id> evidence;
  for (const auto& e : noisy_equilibria(c.subject)) {
    const auto s = c.subject.with(beside(c.subject.scene, e));
    const auto& scheme =
        *std::ranges::find(s.schemes, record.scheme(), [](const scheme_entry& x) { return x.info.name; });
    const auto found = find(s, scheme, e, record);
    all.push_back(judge_growth(scheme, found));
    evidence.insert(evidence.end(), found.rows.begin(), found.rows.end());
  }
  if (!all.empty()) record.verdict("growth of mean squares at the equilibria", worst_of(all), evidence);
}

}  // namespace polhode
