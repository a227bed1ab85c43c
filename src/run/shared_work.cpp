// SPDX-License-Identifier: Apache-2.0
#include "run/shared_work.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "run/run_experiment.hpp"

namespace polhode {
namespace {

/// Those of the ranks with the least load, by load and number.
std::vector<std::size_t> least_loaded(const std::vector<double>& loads, std::size_t count) {
  std::vector<std::size_t> all(loads.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::ranges::stable_sort(all, {}, [&](std::size_t rank) { return loads[rank]; });
  all.resize(count);
  return all;
}

double cost_of(std::span<const scheme_cost> costs, std::string_view experiment,
               const std::vector<std::string>& schemes) {
  double seconds = 0;
  for (const auto& one : costs)
    if (one.experiment == experiment && std::ranges::find(schemes, one.scheme) != schemes.end())
      seconds += one.cpu_seconds;
  return seconds;
}

double total_of(std::span<const scheme_cost> costs) {
  double total = 0;
  for (const auto& one : costs) total += one.cpu_seconds;
  return total;
}

/// Of one experiment, over these ranks.
dealt_schemes deal_among(std::vector<scheme_cost> costs, const std::vector<std::size_t>& these, std::size_t ranks) {
  std::ranges::stable_sort(costs, std::greater{}, &scheme_cost::cpu_seconds);
  std::vector<double> loads(these.size());
  dealt_schemes out(ranks);
  for (const auto& one : costs) {
    const auto least = least_loaded(loads, 1).front();
    loads[least] += one.cpu_seconds;
    out[these[least]].push_back(one.scheme);
  }
  return out;
}

}  // namespace

std::map<std::string, dealt_schemes> deal(std::span<const scheme_cost> costs, int ranks) {
  std::map<std::string, std::vector<scheme_cost>> of;
  for (const auto& one : costs) of[one.experiment].push_back(one);
  std::vector<std::string> experiments;
  for (const auto& [name, its] : of) experiments.push_back(name);
  std::ranges::stable_sort(experiments, std::greater{}, [&](const std::string& name) { return total_of(of[name]); });

  const auto most = static_cast<std::size_t>(ranks);
  const double share = std::max(total_of(costs) / ranks, 1e-300);
  std::vector<double> loads(most);
  std::map<std::string, dealt_schemes> out;
  for (const auto& name : experiments) {
    const double cost = total_of(of[name]);
    const auto wanted = static_cast<std::size_t>(std::clamp(std::round(cost / share), 1.0, 1.0 * ranks));
    const auto these = least_loaded(loads, std::min(wanted, of[name].size()));
    for (const auto rank : these) loads[rank] += cost / static_cast<double>(these.size());
    out[name] = deal_among(of[name], these, most);
  }
  return out;
}

std::vector<scheme_cost> agreed(const std::vector<scheme_cost>& costs, const ranks& among) {
  report::results told;
  for (const auto& one : costs) told.profile.push_back({one.experiment, one.scheme, one.cpu_seconds});
  const auto first = among.of_the_first(told);
  std::vector<scheme_cost> out;
  for (const auto& row : first->profile) out.push_back({row.experiment, row.scheme, row.cpu_seconds});
  return out;
}

std::span<const experiment> sharing::next(std::size_t first) const {
  constexpr double most = 600;  // seconds on the clock, but for one that takes longer alone
  double seconds = 0;
  std::size_t end = first;
  for (; end < experiments_.size() && experiments_[end].kept; ++end) {
    for (const auto& one : costs_)
      if (one.experiment == experiments_[end].info.name) seconds += one.cpu_seconds / among_->size();
    if (end > first && seconds > most) break;
  }
  return experiments_.subspan(first, end - first);
}

shared_work sharing::computed_now(std::span<const experiment> these, const context& c,
                                  const std::function<void(double)>& tell) const {
  std::vector<scheme_cost> costs;
  for (const auto& one : costs_)
    if (std::ranges::any_of(these, [&](const experiment& e) { return e.info.name == one.experiment; }))
      costs.push_back(one);
  shared_work out{deal(costs, among_->size()), {}};
  double own = 1e-300, before = 0;
  for (const auto& [name, dealt] : out.dealt)
    own += cost_of(costs, name, dealt[static_cast<std::size_t>(among_->rank())]);
  for (const auto& e : these) {
    const auto dealt = out.dealt.find(e.info.name);
    if (dealt == out.dealt.end()) continue;
    const auto& schemes = dealt->second[static_cast<std::size_t>(among_->rank())];
    if (schemes.empty()) continue;
    const double cost = cost_of(costs, e.info.name, schemes);
    auto here = c;
    here.progress = [&](double share) { tell((before + share * cost) / own * total_of(costs)); };
    if (!within(budget_, [&] { out.found[e.info.name] = computed(e, here, schemes); })) break;
    before += cost;
  }
  return out;
}

const shared_work* sharing::of(std::size_t i, const context& c, const std::function<void(double)>& tell) {
  if (among_ == nullptr || among_->size() == 1) return nullptr;
  if (i >= end_) {
    const auto these = next(i);
    now_ = computed_now(these, c, tell);
    end_ = i + these.size();
  }
  return i < end_ ? &now_ : nullptr;
}

}  // namespace polhode
