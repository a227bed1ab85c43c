// SPDX-License-Identifier: Apache-2.0
#include "experiments/common/noise_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ensemble/model.hpp"
#include "experiments/common/recorder.hpp"

namespace polhode {
namespace {

noise_audit merged(const std::vector<noise_audit>& blocks) {
  auto sum = blocks.front();
  for (std::size_t i = 1; i < blocks.size(); ++i) sum.merge(blocks[i]);
  return sum;
}

bool smaller(const noise_deviation& a, const noise_deviation& b) { return std::fabs(a.z) < std::fabs(b.z); }

report::verdict judge_deviations(const std::vector<noise_deviation>& all, double increments) {
  const double limit = audit_threshold(all.size());
  const auto& most = *std::ranges::max_element(all, smaller);
  const bool lawful = std::fabs(most.z) <= limit;
  return {.expected = 0.0,
          .estimate = most.z,
          .kind = lawful ? report::verdict_kind::holds : report::verdict_kind::refuted,
          .reason = fmt::format(
              "{} moments and correlations, {:.1e} increments a channel: the largest is the {}, {:.1f} standard errors "
              "from its law, at most {:.1f}; increments off by a factor of {:.5f} would be seen",
              all.size(), increments, most.what, most.z, limit, 1 + limit / std::sqrt(2 * increments))};
}

}  // namespace

noise_log::noise_log(const model& m, int blocks, const std::vector<part>& parts) : layout_(m.layout()) {
  for (const auto& p : parts) open(p, blocks);
}

std::size_t noise_log::open(const part& p, int blocks) {
  parts_.push_back(p);
  audits_.emplace_back(static_cast<std::size_t>(blocks), nothing(p));
  return parts_.size() - 1;
}

noise_audit noise_log::nothing(const part& p) const { return {layout_.active, layout_.active_pairs(), p.cells}; }

audited_steps noise_log::of(const increment_view& v, double dt) const {
  const auto area = layout_.active_pairs() > 0 ? v.area : std::span<const double>{};
  return {v.steps, layout_.channels, layout_.pairs(), v.dw, v.singles, area, dt};
}

void noise_log::add(int block, const increment_view& v, double dt, std::size_t which) {
  at(block, which).add(of(v, dt));
}

void noise_log::add_path(int path, const increment_view& v, double dt, std::size_t which) {
  at(path / noise_audit::lanes, which).add_path(of(v, dt), path % noise_audit::lanes);
}

void noise_log::add_in_turn(std::int64_t first_step, const increment_view& v, double dt, std::size_t which) {
  auto& heard = audits_[which];  // the sum of all blocks that have ended, and the last
  if (heard.size() == 2 && first_step == 0) {
    heard[0].merge(heard[1]);
    heard.pop_back();
  }
  if (first_step == 0 || heard.empty()) heard.push_back(nothing(parts_[which]));
  heard.back().add(of(v, dt));
}

noise_audit noise_log::alone(int path, const increment_view& v, double dt, std::size_t which) const {
  auto heard = nothing(parts_[which]);
  heard.add_path(of(v, dt), path % noise_audit::lanes);
  return heard;
}

void noise_log::report(const std::string& experiment, report::results& out) const {
  recorder record(experiment, noise_name, out);
  std::vector<noise_deviation> all;
  std::vector<report::series_id> evidence;
  double increments = 0;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    if (audits_[i].empty()) continue;
    const auto sum = merged(audits_[i]);
    if (sum.increments() == 0) continue;
    auto found = sum.deviations();
    for (auto& d : found)
      if (!parts_[i].name.empty()) d.what = parts_[i].name + ": " + d.what;
    increments = std::max(increments, sum.increments());
    const auto& most = *std::ranges::max_element(found, smaller);
    evidence.push_back(record.value({"largest deviation", most.what, "standard errors", "sampled"}, most.z));
    all.insert(all.end(), found.begin(), found.end());
  }
  if (!all.empty()) record.verdict(noise_claim, judge_deviations(all, increments), evidence);
}

const scheme_entry& heard_among(const std::vector<scheme_entry>& schemes) {
  const auto with_areas = std::ranges::find(schemes, true, &scheme_entry::needs_areas);
  return with_areas == schemes.end() ? schemes.front() : *with_areas;
}

}  // namespace polhode
