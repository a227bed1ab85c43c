// SPDX-License-Identifier: Apache-2.0
#include "experiments/gibbs/marginal_laws.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "experiments/common/judge.hpp"
#include "experiments/gibbs/gibbs_moments.hpp"

namespace polhode {

marginal_samples::marginal_samples(const subject& s, int paths)
    : laws_(s.offers->gibbs_marginals),
      values_(laws_.size(), std::vector<double>(static_cast<std::size_t>(paths * draws))) {}

void marginal_samples::keep(std::span<const double> mu, std::size_t path, int look, int looks) {
  const int every = looks / draws, draw = (look + 1) / every - 1;
  if ((look + 1) % every != 0 || draw >= draws) return;
  for (std::size_t m = 0; m < laws_.size(); ++m)
    values_[m][path * draws + static_cast<std::size_t>(draw)] = laws_[m].value(mu);
}

std::vector<interval_estimate> marginal_samples::distances(int paths, double times_averaged) const {
  const double neighbours = std::exp(-times_averaged / draws), n = double(paths) * draws;
  std::vector<interval_estimate> out;
  for (std::size_t m = 0; m < laws_.size(); ++m) {
    const auto values = std::span(values_[m]).first(static_cast<std::size_t>(paths * draws));
    const bool finite = std::ranges::all_of(values, [](double x) { return std::isfinite(x); });
    out.push_back(finite ? ks_distance(values, laws_[m].cdf, n * (1 - neighbours) / (1 + neighbours))
                         : interval_estimate{NAN, NAN, NAN});
  }
  return out;
}

bool tight_distances(const std::vector<interval_estimate>& all) {
  return std::ranges::all_of(all, [](const interval_estimate& d) { return d.high - d.value <= ks_bound / 2; });
}

void report_marginals(const subject& s, double dt, const std::vector<interval_estimate>& found, recorder& record) {
  for (std::size_t m = 0; m < found.size(); ++m) {
    const auto& name = s.offers->gibbs_marginals[m].name;
    const auto& d = found[m];
    const auto written = record.value({"ks_distance", name, "", "sampled"}, at_dt(dt), d);
    const bool word = name.find_first_of("_0123456789") == std::string::npos;
    record.verdict(
        (word ? "law of the " : "law of ") + name,
        judge_distance(d, ks_bound,
                       std::isfinite(d.value)
                           ? fmt::format("Kolmogorov-Smirnov distance {:.4f} in [{:.4f}, {:.4f}], bound {:g}", d.value,
                                         d.low, d.high, ks_bound)
                           : "paths were lost: not finite"),
        {written});
  }
}

}  // namespace polhode
