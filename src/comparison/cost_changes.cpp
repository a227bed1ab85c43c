// SPDX-License-Identifier: Apache-2.0
#include "comparison/cost_changes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "comparison/timings.hpp"

namespace polhode {
namespace {

using report::measurement;
using report::results;

constexpr double quantile = 1.96;         // of the intervals
constexpr std::size_t fewest_others = 7;  // by whose scatter one is judged

bool without_noise(const measurement& m) { return m.observable == "energy_law"; }

/// Standard error of log(value).
double relative_error(const measurement& m) {
  if (!m.low || !m.high || !(*m.low > 0)) return 0;
  return std::log(*m.high / *m.low) / (2 * quantile);
}

/// The standard deviation of normal values, by their median distance from their median.
double robust_deviation(std::vector<double> x) {
  const double middle = median_of(x);
  for (double& v : x) v = std::fabs(v - middle);
  return 1.4826 * median_of(std::move(x));
}

/// Three times the largest change but one (of seven that scatter evenly, one is that far ahead in two of a hundred
/// cases).
double scatter_of_others(const std::vector<cost_group*>& groups) {
  std::vector<double> size;
  for (const auto* g : groups) size.push_back(std::fabs(g->median));
  std::ranges::nth_element(size, size.begin() + 1, std::greater{});
  return 3 * size[1];
}

}  // namespace

bool is_cost(const measurement& m) { return m.method == "timed" && m.quantity == "cost" && m.value && m.dt(); }

std::optional<yardstick> yardstick_of(const results& r) {
  for (const auto& m : r.measurements)
    if (m.quantity == "yardstick" && m.method == "timed" && m.value && *m.value > 0)
      return yardstick{*m.value, std::max(*m.value, m.high.value_or(*m.value))};
  return std::nullopt;
}

double difference_of_state(const yardstick& a, const yardstick& b) {
  return std::max(std::fabs(std::log(b.ns / a.ns)), std::fabs(std::log(b.high / a.high)));
}

double median_of(std::vector<double> x) {
  const auto middle = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::ranges::nth_element(x, middle);
  return *middle;
}

std::map<group_key, cost_group> groups_of(const results& before, const results& after, double unit) {
  using row_key = std::tuple<std::string, bool, std::string>;
  const auto key_of = [](const measurement& m) {
    return row_key{m.scheme, without_noise(m), fmt::format("{:.12g}", *m.dt())};
  };
  std::map<row_key, const measurement*> old, now;
  for (const auto& m : before.measurements)
    if (is_cost(m)) old.emplace(key_of(m), &m);
  for (const auto& m : after.measurements)
    if (is_cost(m)) now.emplace(key_of(m), &m);
  std::map<group_key, cost_group> out;
  for (const auto& [key, m] : now) {
    const auto found = old.find(key);
    if (found == old.end() || !(*found->second->value > 0) || !(*m->value > 0)) continue;
    out[{m->scheme, without_noise(*m)}].rows.push_back(
        {*m->dt(), std::log(*m->value / *found->second->value) - unit,
         std::hypot(relative_error(*m), relative_error(*found->second))});
  }
  return out;
}

void judge(cost_group& g, double z) {
  std::vector<double> changes, errors;
  for (const auto& r : g.rows) {
    changes.push_back(r.change);
    errors.push_back(r.error);
  }
  g.median = median_of(changes);
  const double n = static_cast<double>(g.rows.size()), of_median = 1.2533 / std::sqrt(n);
  const double scatter = robust_deviation(changes) * of_median, own = shared * median_of(errors);
  g.threshold = between_runs + z * std::hypot(scatter, own);
}

std::vector<cost_group*> of_kind(std::map<group_key, cost_group>& groups, bool silent) {
  std::vector<cost_group*> out;
  for (auto& [key, g] : groups)
    if (std::get<1>(key) == silent) out.push_back(&g);
  return out;
}

void widen(std::map<group_key, cost_group>& groups, double state) {
  for (const bool silent : {false, true}) {
    const auto same = of_kind(groups, silent);
    const double strain = same.size() < fewest_others ? state : std::min(state, scatter_of_others(same));
    for (auto* g : same) {
      g->strain = strain;
      g->threshold += strain;
    }
  }
}

}  // namespace polhode
