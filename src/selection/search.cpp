// SPDX-License-Identifier: Apache-2.0
#include "selection/search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/common/levels.hpp"
#include "experiments/work_precision/step_cost.hpp"

namespace polhode {
namespace {

constexpr double coarsest_step = 0.5;   // of the fastest time scale
constexpr double share_aimed_at = 0.9;  // of the tolerance that is aimed at
constexpr int most_tries = 10;
constexpr double shortest = 0.1;  // of a step: down to there the tolerance is to be met
constexpr double near = 0.7;      // of the tolerance: between two such steps it is looked once more
constexpr double generous = 0.5;  // of the tolerance: a longer step is worth a try
constexpr int most_lengthened = 3;
constexpr double worthwhile = 1.05;  // times a step: what a longer one must be

}  // namespace

double error_law::at(double dt) const { return factor * std::pow(dt, order); }
double error_law::step_for(double error) const { return std::pow(error / factor, 1 / order); }

search::search(const context& c, const goal& g, const goal_question& q)
    : context_(c), goal_(g), question_(q), rate_(fastest_rate(c.subject)) {}

/// The next shorter step of which a whole number fills the time; at equilibrium any step will do.
double search::whole_steps(double dt) const {
  dt = std::min(dt, goal_.longest_step());
  return question_.name == "stationary" ? dt : question_.time / std::ceil(question_.time / dt * (1 - 1e-12));
}

prospect search::predict(const candidate& who) const {
  prospect out{who, {}, 0, 0, {}};
  if (const auto reason = goal_.cannot_ask(who)) {
    out.fault = *reason;
    return out;
  }
  double dt = whole_steps(coarsest_step / rate_);
  std::array<double, 3> error{};
  for (int i = 0; i < 3; ++i)
    error[static_cast<std::size_t>(i)] = goal_.rough_error(who, dt / (1 << i), context_.seed).value;
  dt /= 4;
  if (!std::isfinite(error[2])) {
    out.fault = fmt::format("not finite at dt = {:.3g}", dt);
    return out;
  }
  const double least = std::max(goal_.floor(), 1e-300), slope = std::log2(error[1] / error[2]);
  // Near the claim the claim is the better exponent far away; a slope well above it is believed where it is seen well
  // above rounding. Whatever is predicted, the check mends.
  const bool faster = std::isfinite(slope) && slope > 1.25 * who.order && slope < 4 * who.order && error[2] > 3 * least;
  const double order = faster ? slope : who.order;
  out.law = error_law{std::max(error[2], least) / std::pow(dt, order), order};
  out.dt = whole_steps(out.law->step_for(share_aimed_at * question_.tolerance));
  // Between measured steps, between what was measured.
  for (int i = 1; i >= 0 && out.dt > dt; --i) {
    const double coarse = error[static_cast<std::size_t>(i)], fine = error[static_cast<std::size_t>(i + 1)];
    const double local = std::log2(coarse / fine), step = dt * (1 << (1 - i)),
                 wanted = share_aimed_at * question_.tolerance;
    if (!(local > 0) || !(fine <= wanted)) break;
    if (coarse <= wanted && i > 0) continue;
    out.dt = whole_steps(std::min(step * std::pow(wanted / fine, 1 / local), coarse <= wanted ? HUGE_VAL : 2 * step));
  }
  return out;
}

choice search::priced(const candidate& who, double dt) const {
  const context where{goal_.priced_on(context_.subject), context_.effort, 1, context_.seed, context_.generator};
  const auto step = cost_of_step(where, who.scheme, dt);
  const double further = step.normals > 0 ? goal_.further_normals(who, dt) : 0;
  const double normal = further > 0 ? ns_per_normal(context_) : 0;
  const auto per_time = [&](double ns) { return who.runs() * (ns + further * normal) / dt; };
  return {who.name, dt, 0, 0, 0, 0, per_time(step.ns), per_time(step.low), per_time(step.high)};
}

void search::price(prospect& p) const {
  if (p.fault.empty()) p.cost = priced(p.who, p.dt).cost;
}

std::vector<double> search::rungs_below(double dt) const {
  const int rungs = goal_.rungs();
  std::vector<double> out;
  for (int i = 0; i <= rungs; ++i) {
    const double next = whole_steps(dt * std::pow(shortest, static_cast<double>(i) / rungs));
    if (out.empty() || next < out.back()) out.push_back(next);
  }
  return out;
}

/// Of a parabola through three values at about equal distances, the middle one the largest.
double peak(double before, double middle, double after) {
  const double bend = before - 2 * middle + after, slope = (after - before) / 2;
  return bend < 0 ? middle - slope * slope / (2 * bend) : middle;
}

descent search::look_below(const candidate& who, double dt, std::uint64_t seed) const {
  descent out{dt, {}, 0, 0, dt};
  std::vector<double> steps, bounds;
  for (const double step : rungs_below(dt)) {
    if (step < dt && !goal_.affordable(who, step)) break;
    const auto e = step == dt ? goal_.error(who, step, seed) : goal_.rough_error(who, step, seed);
    if (step == dt) out.at_longest = e;
    steps.push_back(step);
    bounds.push_back(e.bound());
    const std::size_t n = bounds.size();
    const bool hill = n > 2 && bounds[n - 2] > bounds[n - 3] && bounds[n - 2] > bounds[n - 1];
    const double highest = hill ? peak(bounds[n - 3], bounds[n - 2], bounds[n - 1]) : e.bound();
    out.worst = std::isfinite(highest) ? std::max(out.worst, highest) : highest;
    out.shortest = step;
    if (!(highest <= question_.tolerance)) {
      out.too_long = step;
      return out;
    }
  }
  // A combination's error may have hills narrower than a rung.
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    if (std::max(bounds[i], bounds[i + 1]) < near * question_.tolerance) continue;
    const double between = whole_steps(std::sqrt(steps[i] * steps[i + 1]));
    if (between >= steps[i] || between <= steps[i + 1]) continue;
    const double bound = goal_.rough_error(who, between, seed).bound();
    out.worst = std::isfinite(bound) ? std::max(out.worst, bound) : bound;
    if (bound <= question_.tolerance) continue;
    out.too_long = between;
    break;
  }
  return out;
}

/// From a step that is better than it need be, towards the one that is too long: between the two by a power law, and
/// where none is known by the scheme's own.
double search::longer_than(const descent& good, const std::optional<descent>& bad, double order) const {
  const double aim = share_aimed_at * question_.tolerance;
  const double own = good.longest * std::clamp(std::pow(aim / good.worst, 1 / order), 1.0, 4.0);
  if (!bad || !std::isfinite(bad->worst)) return whole_steps(bad ? std::sqrt(good.longest * bad->too_long) : own);
  const double part = std::log(aim / good.worst) / std::log(bad->worst / good.worst);
  return whole_steps(std::min(4 * good.longest, good.longest * std::pow(bad->too_long / good.longest, part)));
}

choice search::found(const prospect& p, const descent& seen) const {
  auto out = priced(p.who, seen.longest);
  out.predicted = p.law->at(seen.longest);
  out.checked = seen.at_longest.value;
  out.bound = seen.worst;
  out.checked_to = seen.shortest;
  out.order = p.law->order;
  out.observed = seen.at_longest.observed;
  return out;
}

std::optional<choice> search::check(const prospect& p, std::string& fault) const {
  std::optional<descent> good, bad;
  double dt = p.dt;
  for (int i = 0, lengthened = 0; i < most_tries; ++i) {
    if (!goal_.affordable(p.who, dt)) {
      if (!good) fault = goal_.dear_check(p.who, dt);
      break;
    }
    const auto seen = look_below(p.who, dt, context_.seed + 1 + static_cast<std::uint64_t>(i));
    if (seen.too_long == 0)
      good = seen;
    else if (!bad || seen.too_long < bad->too_long)
      bad = seen;
    if (good && seen.too_long > 0 && seen.too_long <= good->longest) good.reset();  // a hill between its rungs
    if (!good) {
      fault = fmt::format("error {:.2g} at dt = {:.3g}", seen.worst, seen.too_long);
      const double factor = std::pow(share_aimed_at * question_.tolerance / seen.worst, 1 / p.law->order);
      dt = whole_steps(seen.too_long * (std::isfinite(factor) ? std::clamp(factor, 0.1, 4.0) : 0.25));
      continue;
    }
    if (good->worst >= generous * question_.tolerance || lengthened++ == most_lengthened) break;
    dt = longer_than(*good, bad, p.law->order);
    if (dt < worthwhile * good->longest) break;
  }
  return good ? std::optional(found(p, *good)) : std::nullopt;
}

}  // namespace polhode
