// SPDX-License-Identifier: Apache-2.0
#include "experiments/work_precision/known_errors.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/laws/transfer_report.hpp"
#include "experiments/weak/weak_sampled.hpp"
#include "experiments/work_precision/energy_error.hpp"
#include "experiments/work_precision/known_law_errors.hpp"
#include "problem/vectors.hpp"
#include "transfer/operator_store.hpp"

namespace polhode {
namespace {

/// The unit of a row's error; none where the row is no error of this kind.
using unit_of_row = std::function<std::optional<double>(const report::measurement&)>;

known_error in_units(const report::measurement& m, double unit) {
  const double value = std::fabs(*m.value) / unit;
  return {m.scheme, *m.dt(), value, m.low ? std::max(0.0, *m.low / unit) : value, m.high ? *m.high / unit : value};
}

void gather(const report::results& before, error_kind& kind, const unit_of_row& unit_of) {
  for (const auto& m : before.measurements) {
    if (m.experiment != kind.source || !m.value || !m.dt()) continue;
    const auto unit = unit_of(m);
    if (!unit || !(*unit > 0)) continue;
    const auto found = in_units(m, *unit);
    const auto same = std::ranges::find_if(
        kind.errors, [&](const known_error& e) { return e.scheme == found.scheme && e.dt == found.dt; });
    if (same == kind.errors.end())
      kind.errors.push_back(found);
    else if (found.value > same->value)
      *same = found;
  }
}

unit_of_row constant(std::string quantity, double unit) {
  return [quantity, unit](const report::measurement& m) {
    return m.quantity == quantity ? std::optional(unit) : std::nullopt;
  };
}

/// In units of the observable's root mean square over the sphere.
unit_of_row by_observable(const subject& s, std::string quantity) {
  return [problem = s.sphere(), quantity](const report::measurement& m) -> std::optional<double> {
    if (m.quantity != quantity || !problem) return std::nullopt;
    if (m.observable == "energy^2")
      return size_on_sphere([&](const Eigen::Vector3d& x) { return std::pow(problem->energy(x), 2); }, problem->radius);
    const auto f = named_observable(m.observable, *problem);
    return f ? std::optional(size_on_sphere(*f, problem->radius)) : std::nullopt;
  };
}

/// Off the sphere: what `weak` samples of all observables together, each in units of its own size already.
unit_of_row of_all_together() {
  return [](const report::measurement& m) {
    const bool is_one = m.quantity == sampled_error && m.observable == all_together;
    return is_one ? std::optional(1.0) : std::nullopt;
  };
}

/// Root mean square of the relative change of the Casimirs of one block of paths, with its standard error twice either
/// side; not less than one rounding.
known_error casimir_change(const context& c, const scheme_entry& scheme, int steps, double dt) {
  const auto& m = *c.subject.model;
  auto states = replicated(c.subject.scene.momentum);
  increment_buffer noise(m, steps, scheme.needs_areas, {c.generator, noise_quality::fast});
  scheme.make(dt)->advance(states, !m.layout().silent() ? noise.fill(c.seed, 0, 0, steps, dt) : silence(steps));
  const auto start = m.casimirs(c.subject.scene.momentum), sizes = m.casimir_sizes(c.subject.scene.momentum);
  double sum = 0, squares = 0;
  for (int lane = 0; lane < block_lanes; ++lane) {
    const auto now = m.casimirs(lane_of(states, lane, m.dimension()));
    double worst = 0;
    for (std::size_t i = 0; i < now.size(); ++i)
      worst = std::max(worst, std::pow((now[i] - start[i]) / std::max(sizes[i], 1e-300), 2));
    sum += worst / block_lanes;
    squares += worst * worst / block_lanes;
  }
  const double spread = 2 * std::sqrt(std::max(0.0, squares - sum * sum) / block_lanes);
  const auto root = [](double x) {
    return std::max(std::sqrt(std::max(0.0, x)), std::numeric_limits<double>::epsilon());
  };
  return {std::string(scheme.info.name), dt, root(sum), root(sum - spread), root(sum + spread)};
}

void add_kept_casimirs(const context& c, error_kind& kind) {
  const auto grid = asymptotic_levels(c.subject, 256);
  const auto dt = grid.dt();
  for (const auto& scheme : c.subject.schemes)
    if (scheme.info.casimir.exact)
      for (std::size_t l = 0; l < dt.size(); ++l)
        kind.errors.push_back(casimir_change(c, scheme, grid.steps[l], dt[l]));
}

/// By the measure that `select` uses, after the scene's horizon.
void add_energy_errors(const context& c, error_kind& kind) {
  constexpr int most_steps = 1024;
  const auto still = c.subject.without_noise();
  const energy_truth truth(still, still.scene.horizon);
  const int first = std::max(1, static_cast<int>(std::ceil(still.scene.horizon * fastest_rate(still) / 2)));
  for (const auto& scheme : still.schemes)
    for (int steps = first; steps <= std::max(most_steps, 16 * first); steps *= 2) {
      const double dt = still.scene.horizon / steps, error = truth.error(scheme, dt);
      if (std::isfinite(error)) kind.errors.push_back({std::string(scheme.info.name), dt, error, error, error});
    }
}

}  // namespace

std::vector<error_kind> known_errors(const context& c) {
  const auto& s = c.subject;
  const auto& before = *c.before;
  const double momentum = length(s.scene.momentum);
  std::vector<error_kind> kinds{{"strong", "strong", "|Pi_0|", false, true},
                                {"weak", "weak", s.sphere() ? "size of the observable" : "sizes of all observables"},
                                {"stationary", "gibbs", "size of the observable"},
                                {"energy_law", "energy", "h_0", true},
                                {"casimir", "casimir", "relative"}};
  gather(before, kinds[0], constant("error", momentum));
  gather(before, kinds[1], s.sphere() ? by_observable(s, "error") : of_all_together());
  gather(before, kinds[2], by_observable(s, "bias"));
  gather(before, kinds[4], constant("drift", 1));
  constexpr double accuracy = 1e-12;  // of the truth
  operator_store kept(s);
  if (s.sphere() && !kinds[1].errors.empty())
    measure_on_the_sphere(c, weak_law(s, s.scene.horizon, accuracy, &kept), s.scene.horizon, kinds[1]);
  if (!kinds[2].errors.empty()) {
    const equilibrium_law law(s, accuracy, &kept);
    if (law.reason().empty()) measure_on_the_sphere(c, law, longest_at_equilibrium(s), kinds[2]);
  }
  const auto ran = [&](const char* name) {
    return std::ranges::find(before.experiments, name, &report::experiment::name) != before.experiments.end();
  };
  if (ran("energy") && !beyond_reach(s)) add_energy_errors(c, kinds[3]);
  if (ran("casimir")) add_kept_casimirs(c, kinds[4]);
  return kinds;
}

}  // namespace polhode
