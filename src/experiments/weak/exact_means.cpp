// SPDX-License-Identifier: Apache-2.0
#include "experiments/weak/exact_means.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/common/recorder.hpp"
#include "sphere/products/pair_expectations.hpp"
#include "statistics/noise/noise_audit.hpp"

namespace polhode {
namespace {

constexpr double share = 1e-4;              // of an observable's size
constexpr int highest_degree = 16;          // seconds, of all observables
constexpr double interval_of_means = 1.96;  // standard errors

}  // namespace

bool exact_means::known() const {
  return std::ranges::any_of(of, [](const reference_value& v) { return v.converged(); });
}

exact_means exact_means_of(const subject& s, const std::vector<observable>& observables, double time) {
  exact_means out{std::vector<reference_value>(observables.size())};
  const auto& pair = s.offers->pair;
  if (!pair) return out;
  pair_expectations exact(*pair, Eigen::Map<const Eigen::Matrix<double, 6, 1>>(s.scene.momentum.data()), time,
                          highest_degree);
  for (std::size_t i = 0; i < observables.size(); ++i) {
    const auto f = site_observable_named(observables[i].name, 2);
    if (!f) continue;
    out.of[i] = exact.agreed(*f, share);
    if (out.of[i].converged()) continue;
    out.reason = fmt::format("E[{}] is {}", observables[i].name, out.of[i].reason);
    if (i == 0) break;  // nor would the others be
  }
  return out;
}

bool held_truth::agrees() const {
  return std::ranges::all_of(means, [&](const mean& m) { return std::fabs(m.z) <= limit; });
}

std::string held_truth::text() const {
  if (means.empty()) return {};
  const auto& most = *std::ranges::max_element(means, {}, [](const mean& m) { return std::fabs(m.z); });
  return fmt::format(
      "; {} exact means: the driven equation's E[{}] is the furthest, {:.1f} standard errors, at most {:.1f}",
      means.size(), most.observable, most.z, limit);
}

held_truth held_to(const exact_means& exact, const std::vector<observable>& observables,
                   const std::vector<squared_errors>& values) {
  held_truth out;
  for (std::size_t i = 0; i < observables.size(); ++i) {
    if (!exact.of[i].converged()) continue;
    const auto m = level_mean(values[i], 0);
    const double apart = m.mean - *exact.of[i].value;
    const double clear = std::max(0.0, std::fabs(apart) - exact.of[i].uncertainty);
    out.means.push_back({observables[i].name, m, exact.of[i], clear > 0 ? std::copysign(clear / m.error, apart) : 0.0});
  }
  out.limit = audit_threshold(out.means.size());
  return out;
}

void report_truth(const held_truth& truth, report::results& out) {
  recorder record("weak", "", out);
  for (const auto& [name, sampled, exact, z] : truth.means) {
    record.value({"true mean", name, "", "exact"}, *exact.value, *exact.value - exact.uncertainty,
                 *exact.value + exact.uncertainty);
    record.value({"mean of the driven equation", name, "", "sampled"}, sampled.mean,
                 sampled.mean - interval_of_means * sampled.error, sampled.mean + interval_of_means * sampled.error);
    record.value({"distance from the true mean", name, "standard errors", "sampled"}, z);
  }
}

void hold_to(const held_truth& truth, report::verdict& v) {
  v.reason += truth.text();
  if (truth.agrees()) return;
  v.kind = report::verdict_kind::inconclusive;
  v.reason += ": it does not have the exact means, and decides nothing";
}

}  // namespace polhode
