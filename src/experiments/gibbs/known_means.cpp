// SPDX-License-Identifier: Apache-2.0
#include "experiments/gibbs/known_means.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "experiments/common/judge.hpp"

namespace polhode {
namespace {

/// Observables of one claim: of the energy, of components, of squares.
std::string claim_on(const std::string& observable) {
  return observable == "energy"       ? "mean of energy"
         : observable.ends_with("^2") ? "means of squares of components"
                                      : "means of components";
}

/// Of the far end of an interval, in margins: one that lies beyond its margin counts for more than a wide one, one that
/// is not finite for most.
double distance_from(const known_mean& m, const interval_estimate& i) {
  const double beyond = std::max(i.low - m.exact, m.exact - i.high) / m.margin(),
               reach = std::max(i.high - m.exact, m.exact - i.low) / m.margin();
  return !std::isfinite(reach) ? HUGE_VAL : beyond > 1 ? 1e9 + beyond : reach;
}

}  // namespace

void report_known_means(const std::vector<observable>& observables, const std::vector<known_mean>& means, double dt,
                        const std::vector<interval_estimate>& found, recorder& record) {
  struct of_claim {
    report::verdict worst;
    double distance = -1;
    std::vector<report::series_id> evidence = {};  ///< the mean that decides, as the expected value is its own
    int count = 0;
  };
  std::map<std::string, of_claim> claims;
  double least = HUGE_VAL;
  for (std::size_t f = 0; f < found.size(); ++f) {
    const auto& name = observables[f].name;
    const auto& [exact, deviation] = means[f];
    const double effective = std::pow(1.96 * deviation / half_width(found[f]), 2);
    least = std::min(least, effective);
    auto& claim = claims[claim_on(name)];
    const auto written = record.value({"mean", name, "", "sampled"}, at_dt(dt), found[f]);
    ++claim.count;
    const double distance = distance_from(means[f], found[f]);
    if (distance <= claim.distance) continue;
    claim.distance = distance;
    claim.evidence = {written};
    claim.worst = judge_mean(exact, means[f].margin(), found[f]);
    claim.worst.reason = fmt::format("{}: {}; worth {:.2g} independent samples", name, claim.worst.reason, effective);
  }
  record.value({"effective sample size", "the slowest mean", "", "sampled"}, at_dt(dt), least);
  for (auto& [claim, f] : claims) {
    if (f.count > 1) f.worst.reason += fmt::format("; the farthest of {}", f.count);
    record.verdict(claim, std::move(f.worst), f.evidence);
  }
}

}  // namespace polhode
