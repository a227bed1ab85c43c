// SPDX-License-Identifier: Apache-2.0
#include "experiments/work_precision/price_list.hpp"

#include <algorithm>

#include "experiments/common/levels.hpp"
#include "experiments/laws/extrapolation.hpp"
#include "experiments/work_precision/path_cells.hpp"

namespace polhode {
namespace {

/// Whose steps a scheme's are, and in how many runs.
struct origin {
  std::string scheme;
  int runs = 1;
};

origin origin_of(const std::string& scheme) {
  for (const auto& e : extrapolations)
    if (e.name == scheme) return {std::string(extrapolated_from), e.levels()};
  return {scheme};
}

const scheme_entry* entry_of(const subject& s, const std::string& scheme) {
  const auto found = std::ranges::find(s.schemes, scheme, [](const scheme_entry& e) { return e.info.name; });
  return found == s.schemes.end() ? nullptr : &*found;
}

}  // namespace

price_list::price_list(const context& c)
    : still_(c.subject.without_noise()),
      noisy_context_{c.subject, c.effort, 1, c.seed, c.generator},
      still_context_{still_, c.effort, 1, c.seed, c.generator} {}

void price_list::want(const std::string& scheme, double dt, bool silent) {
  const auto from = origin_of(scheme);
  if (!entry_of(noisy_context_.subject, from.scheme)) return;
  for (int run = 0; run < from.runs; ++run, dt /= 2) known_.try_emplace({from.scheme, dt, silent});
}

void price_list::measure() {
  std::vector<priced_step> steps;
  for (const auto& [k, _] : known_) {
    const auto& [scheme, dt, silent] = k;
    const auto& where = silent ? still_context_ : noisy_context_;
    steps.push_back({&where, entry_of(where.subject, scheme), dt});
  }
  const auto costs = costs_of_steps(steps, &yardstick_);
  std::size_t i = 0;
  for (auto& [_, cost] : known_) cost = costs[i++];
  ns_per_normal_ = ns_per_normal(noisy_context_);
}

std::optional<price> price_list::of_path_with_cells(const std::string& scheme, double dt) const {
  auto out = of_path(scheme, dt, false);
  const auto& s = noisy_context_.subject;
  const auto* entry = entry_of(s, scheme);
  const int channels = s.model->layout().active;
  if (!out || !entry || !entry->needs_areas || channels < 2) return out;
  const double further = (cells_for_areas(fastest_rate(s), dt) - 1.0) * channels / dt;
  out->normals += further;
  for (double* part : {&out->ns, &out->low, &out->high}) *part += further * ns_per_normal_;
  return out;
}

std::optional<price> price_list::of_path(const std::string& scheme, double dt, bool silent) const {
  const auto from = origin_of(scheme);
  price sum;
  for (int run = 0; run < from.runs; ++run, dt /= 2) {
    const auto step = known_.find({from.scheme, dt, silent});
    if (step == known_.end()) return std::nullopt;
    sum.steps += 1 / dt;
    sum.normals += step->second.normals / dt;
    sum.ns += step->second.ns / dt;
    sum.low += step->second.low / dt;
    sum.high += step->second.high / dt;
  }
  return sum;
}

}  // namespace polhode
