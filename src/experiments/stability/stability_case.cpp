// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability/stability_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ensemble/coadjoint_matrices.hpp"
#include "ensemble/noise/paths.hpp"
#include "experiments/common/levels.hpp"
#include "problem/vectors.hpp"
#include "sphere/equilibria.hpp"

namespace polhode {
namespace {

constexpr double least_scales = 64;  // of the horizon
constexpr double stiffness = 1e4;    // of the dissipation against everything else
constexpr double denormal = 1e-310;

using scene = report::scene;

/// Around 1: factor^-k … factor^k, an odd number of them.
std::vector<double> around(int points, double factor) {
  std::vector<double> out;
  for (int i = 0; i < points; ++i) out.push_back(std::pow(factor, i - points / 2));
  return out;
}
int points(effort e) { return by_effort(e, 3, 5, 9); }
double factor(effort e) { return by_effort(e, 16.0, 8.0, 4.0); }

/// Of three components at any size: their squares may not be numbers.
double radius_of(const scene& s) {
  const auto& mu = s.momentum;
  return mu.size() == 3 ? std::hypot(mu[0], mu[1], mu[2]) : length(mu);
}

/// On an equilibrium that is neither a well nor a peak, or else of middle energy, but for a part `aside` of the length:
/// near the separatrix.
scene near_saddle(scene s, const sphere_problem& p, double aside) {
  auto all = equilibria(p);
  std::ranges::stable_sort(all, std::ranges::greater{}, &equilibrium::energy);
  const auto saddle = std::ranges::find_if(all, [](const auto& e) { return e.curvature[0] < 0 && e.curvature[1] > 0; });
  const auto& at = saddle != all.end() ? saddle->direction : all[(all.size() - 1) / 2].direction;
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = at[static_cast<Eigen::Index>(k)];
    s.momentum[k] = p.radius * (x != 0 ? x : aside);
  }
  return s;
}

scene with_momentum(scene s, double by) {
  for (double& x : s.momentum) x *= by;
  return s;
}
/// Below it the squares of small components are lost, and with them digits of |Pi|.
const double least_radius = std::sqrt(std::numeric_limits<double>::min()) / std::numeric_limits<double>::epsilon();

void bound_by_sphere(stability_case& c) {
  const auto extremes = equilibria(*c.bound.sphere());
  const double radius = radius_of(c.bound.scene);
  c.casimirs = c.casimir_sizes = {radius};
  c.least_energy = extremes.front().energy;
  c.greatest_energy = extremes.back().energy;
  c.normal = radius >= least_radius;
}

stability_case bound_case(std::string name, const subject& own, const scene& changed, effort e) {
  stability_case c{.name = std::move(name), .bound = own.with(changed)};
  c.rate = fastest_rate(c.bound);
  c.horizon = std::clamp(changed.horizon, least_scales / c.rate, by_effort(e, 128, 256, 1024) / c.rate);
  c.bounded = c.bound.sphere().has_value();
  if (c.bounded)
    bound_by_sphere(c);
  else {
    c.casimirs = c.bound.model->casimirs(changed.momentum);
    c.casimir_sizes = c.bound.model->casimir_sizes(changed.momentum);
    c.compact = keeps_length(*c.bound.model);
    for (double& size : c.casimir_sizes) size = std::max(size, 1e-300);
  }
  return c;
}

/// Four digits name a place well enough.
report::coordinate place(std::string_view axis, double x) {
  return {std::string(axis), std::stod(fmt::format("{:.4g}", x)), ""};
}

void add_axes(const subject& s, effort e, std::vector<stability_case>& out) {
  const auto& own = s.scene;
  const auto add = [&](std::string_view axis, double x, const scene& changed) {
    out.push_back(bound_case("", s, changed, e));
    out.back().changed = place(axis, x);
  };
  const auto steps = around(points(e), factor(e));
  for (const double by : steps)
    if (by != 1 && s.model->noise() != noise_class::none)
      add("sigma factor", std::sqrt(by), with_noise_times(own, std::sqrt(by)));
  for (const double x : stiffness_axis(s, e)) add(dissipation_key, x, with_dissipation(own, x));
  for (const double by : steps)
    if (by != 1 && s.sphere()) add("c", by * radius_of(own), with_momentum(own, by));
  const auto& shape = s.offers->shape;
  for (int i = 0, n = points(e); shape && i < n; ++i) {
    const double x = shape->least * std::pow(shape->greatest / shape->least, static_cast<double>(i) / (n - 1));
    add(shape->name, x, shape->at(x));
  }
}

void add_stiff(const subject& s, effort e, std::vector<stability_case>& out) {
  const auto& rates = s.offers->rates;
  if (!(rates.damping > 0)) return;
  const double strength = stiffness * (rates.fastest() - rates.dissipation) / rates.damping;
  out.push_back(bound_case("stiff", s, with_dissipation(s.scene, strength), e));
}

void add_corners_of_sphere(const subject& s, effort e, std::vector<stability_case>& out) {
  const auto& own = s.scene;
  const auto& p = *s.sphere();
  const auto& shape = s.offers->shape;
  out.push_back(bound_case("separatrix", s, near_saddle(own, p, 1e-6), e));
  if (shape) out.push_back(bound_case(shape->name_of_nearly_none, s, shape->nearly_none, e));
  add_stiff(s, e, out);
  out.push_back(bound_case("denormal components", s, near_saddle(own, p, denormal), e));
  out.push_back(bound_case("denormal c", s, with_momentum(own, denormal / radius_of(own)), e));
  out.back().rate = out.front().rate;  // without noise it has no rate of its own
  out.back().horizon = out.front().horizon;
}

}  // namespace

std::vector<double> stiffness_axis(const subject& s, effort e) {
  if (!(s.offers->rates.damping > 0)) return {};
  const double own = dissipation_of(s.scene), middle = own > 0 ? own : 1 / radius_of(s.scene);
  std::vector<double> out = around(points(e), factor(e));
  for (double& x : out) x *= middle;
  return out;
}

report::measurement row_in(const stability_case& in, quantity what, std::optional<double> value) {
  report::measurement m{.quantity = std::move(what.name),
                        .observable = in.name,
                        .value = value,
                        .unit = std::move(what.unit),
                        .method = std::move(what.method)};
  if (in.changed) m.at.push_back(*in.changed);
  return m;
}

std::vector<stability_case> stability_cases(const context& c) {
  std::vector<stability_case> out{bound_case("scene", c.subject, c.subject.scene, c.effort)};
  add_axes(c.subject, c.effort, out);
  c.subject.sphere() ? add_corners_of_sphere(c.subject, c.effort, out) : add_stiff(c.subject, c.effort, out);
  std::erase_if(out, [](const stability_case& s) { return !std::isfinite(s.rate * s.horizon) || !(s.rate > 0); });
  return out;
}

}  // namespace polhode
