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

using report::audited_noise;
using deviations = std::vector<audited_noise::deviation>;

const audited_noise::deviation& largest(const deviations& all) {
  return *std::ranges::max_element(all, {}, [](const auto& d) { return std::fabs(d.z); });
}

report::verdict judge_deviations(const deviations& all, double increments) {
  const double limit = audit_threshold(all.size());
  const auto& most = largest(all);
  const bool lawful = std::fabs(most.z) <= limit;
  return {.expected = 0.0,
          .estimate = most.z,
          .kind = lawful ? report::verdict_kind::holds : report::verdict_kind::refuted,
          .reason = fmt::format(
              "{} moments and correlations, {:.1e} increments a channel: the largest is the {}, {:.1f} standard errors "
              "from its law, at most {:.1f}; increments off by a factor of {:.5f} would be seen",
              all.size(), increments, most.what, most.z, limit, 1 + limit / std::sqrt(2 * increments))};
}

/// In the place of those rows that answer to `are`, or at the end.
template <class Row, class Are>
void put(std::vector<Row>& rows, const std::vector<Row>& instead, Are are) {
  const auto before = std::ranges::find_if(rows, are) - rows.begin();
  std::erase_if(rows, are);
  rows.insert(rows.begin() + before, instead.begin(), instead.end());
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

void noise_log::report(const std::string& experiment, report::results& out, std::string_view scheme) const {
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    auto& heard = out.audits.emplace_back(audited_noise{experiment, parts_[i].name, std::string(scheme)});
    if (audits_[i].empty()) continue;
    const auto sum = merged(audits_[i]);
    heard.increments = sum.increments();
    heard.areas = sum.areas();
    if (heard.increments == 0) continue;
    for (const auto& d : sum.deviations()) (d.of_area ? heard.of_areas : heard.of_increments).push_back({d.what, d.z});
  }
  report_noise(experiment, out);
}

void report_noise(const std::string& experiment, report::results& out) {
  constexpr const char* quantity = "largest deviation";
  report::results rows;
  recorder record(experiment, noise_name, rows);
  deviations all;
  std::vector<report::series_id> evidence;
  double increments = 0;
  for (const auto& heard : out.audits) {
    if (heard.experiment != experiment || heard.increments == 0) continue;
    deviations found;
    for (const auto* some : {&heard.of_increments, &heard.of_areas})
      for (const auto& d : *some) found.push_back({heard.part.empty() ? d.what : heard.part + ": " + d.what, d.z});
    increments = std::max(increments, heard.increments);
    const auto& most = largest(found);
    evidence.push_back(record.value({quantity, most.what, "standard errors", "sampled"}, most.z));
    all.insert(all.end(), found.begin(), found.end());
  }
  if (!all.empty()) record.verdict(noise_claim, judge_deviations(all, increments), evidence);
  const auto of_noise = [&](const auto& row) { return row.experiment == experiment && row.scheme == noise_name; };
  put(out.measurements, rows.measurements, [&](const auto& m) { return of_noise(m) && m.quantity == quantity; });
  put(out.verdicts, rows.verdicts, [&](const auto& v) { return of_noise(v) && v.claim == noise_claim; });
}

std::vector<audited_noise> as_of_one_run(std::span<const report::results> runs,
                                         const std::vector<scheme_entry>& schemes) {
  const auto further = [&](const audited_noise& than, const audited_noise& next) {
    if (than.scheme == next.scheme) return next.increments > than.increments;
    std::vector<scheme_entry> both;
    std::ranges::copy_if(schemes, std::back_inserter(both), [&](const scheme_entry& s) {
      return s.info.name == than.scheme || s.info.name == next.scheme;
    });
    return heard_among(both).info.name == next.scheme;
  };
  std::vector<audited_noise> out;
  for (const auto& run : runs)
    for (const auto& next : run.audits) {
      const auto known = std::ranges::find(out, next.part, &audited_noise::part);
      if (known == out.end()) {
        out.push_back(next);
        continue;
      }
      auto both = further(*known, next) ? next : *known;
      if (known->scheme == next.scheme) {
        const auto& areas = next.areas > known->areas ? next : *known;
        both.areas = areas.areas;
        both.of_areas = areas.of_areas;
      }
      *known = std::move(both);
    }
  return out;
}

const scheme_entry& heard_among(const std::vector<scheme_entry>& schemes) {
  const auto first = [&](auto is) { return std::ranges::find_if(schemes, is); };
  const auto exact = [](const scheme_entry& s) { return s.info.casimir.exact; };
  if (const auto one = first([&](const auto& s) { return exact(s) && s.needs_areas; }); one != schemes.end())
    return *one;
  if (const auto one = first(exact); one != schemes.end()) return *one;
  const auto one = first([](const auto& s) { return s.needs_areas; });
  return one != schemes.end() ? *one : schemes.front();
}

}  // namespace polhode
