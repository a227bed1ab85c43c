// SPDX-License-Identifier: Apache-2.0
#include "run/foreign_runs.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <optional>
#include <string_view>

#include "experiments/common/dear_experiments.hpp"
#include "experiments/gibbs/gibbs_sampled.hpp"
#include "experiments/laws/transfer_report.hpp"
#include "experiments/weak/weak_alone.hpp"
#include "run/run_experiment.hpp"

namespace polhode {
namespace {

constexpr std::string_view works = "the integrator works";

constexpr std::array<std::string_view, 4> of_one_noise{"strong", "attractor", "lyapunov", "modified"};

bool needs_increments(const experiment& e) {
  return std::ranges::find(of_one_noise, e.info.name) != of_one_noise.end();
}

/// Without the operators of a sphere, here and on every changed scene.
subject sampled(subject s) {
  auto offers = std::make_shared<capabilities>(*s.offers);
  offers->sphere.reset();
  s.offers = offers;
  s.with = [with = s.with](const report::scene& other) { return sampled(with(other)); };
  return s;
}

/// Nothing: it asks as much of whatever comes through any door. By the door and not by the clock, so that another
/// machine asks the same.
std::optional<experiment> shortened(const experiment& e) {
  if (e.info.name == "casimir") return dear_casimir_experiment();
  if (e.info.name == "stability") return dear_stability_experiment();
  return {};
}

/// The part of schemes that draw random numbers of their own.
part alone(experiment e, subject s) {
  if (e.info.name == "weak") {
    e.run = [](const context& c, report::results& out) {
      report_orders_alone(
          c, [&](const scheme_entry& one) { return weak_order_on(one.info, c.subject.model->noise()); }, out);
    };
    return {std::move(s), std::move(e)};
  }
  if (e.info.name != "gibbs" || !s.sphere()) return {sampled(std::move(s)), std::move(e)};
  e.run = [](const context& c, report::results& out) { report_sampled_law(c, out); };
  return {std::move(s), std::move(e)};
}

bool is_reported(const report::results& so_far, std::string_view scheme) {
  return std::ranges::any_of(so_far.verdicts,
                             [&](const report::verdict& v) { return v.scheme == scheme && v.claim == works; });
}

/// Of the first that says something.
std::string said_by_any(const std::string& mine, const ranks& among) {
  for (const auto& words : among.told_by_all(mine))
    if (!words.empty()) return words;
  return "";
}

foreign::claims of_the_first(const foreign::claims& mine, const ranks& among) {
  using bytes = std::array<char, sizeof mine>;
  auto told = std::bit_cast<bytes>(mine);
  std::ranges::copy(among.told_by_all({told.begin(), told.end()}).front(), told.begin());
  return std::bit_cast<foreign::claims>(told);
}

}  // namespace

std::vector<part> parts_for(const experiment& e, const subject& s, const foreign::foreign_schemes& foreign,
                            report::results& out) {
  if (foreign.empty()) return {{s, e}};
  std::vector<std::string> driven, apart, own;
  for (const auto& entry : s.schemes) {
    const std::string name(entry.info.name);
    const auto* of = find_foreign(foreign, name);
    const bool draws = of != nullptr && of->about().takes == foreign::noise_access::own_numbers;
    if (of != nullptr && of->failure())
      out.skipped.push_back({e.info.name, name, "the integrator has failed: " + *of->failure()});
    else if (draws && needs_increments(e))
      out.skipped.push_back({e.info.name, name,
                             "draws random numbers of its own: two runs under one noise, which this compares, need an "
                             "integrator that takes increments"});
    else
      (draws ? own : of != nullptr && of->about().apart ? apart : driven).push_back(name);
  }
  std::vector<part> parts;
  const auto shorter = shortened(e);
  if (!shorter) std::ranges::copy(apart, std::back_inserter(driven));
  if (!driven.empty()) parts.push_back({restricted(s, driven), e});
  if (shorter && !apart.empty()) parts.push_back({restricted(s, apart), *shorter});
  if (!own.empty()) parts.push_back(alone(e, restricted(s, own)));
  if (shorter)
    for (const auto& name : apart)
      out.savings.push_back({e.info.name,
                             name,
                             e.info.name == "casimir" ? "all but a tenth of the million steps, the drift taken on"
                                                      : "cases with parameters moved",
                             "its steps are asked of a process or an interpreter",
                             {}});
  return parts;
}

void append_of_schemes(const subject& part, report::results more, report::results& out) {
  const auto of_part = [&](const auto& row) {
    return std::ranges::any_of(part.schemes, [&](const scheme_entry& e) { return e.info.name == row.scheme; });
  };
  const auto append = [&](auto rows) { std::ranges::copy_if(more.*rows, std::back_inserter(out.*rows), of_part); };
  append(&report::results::measurements);
  append(&report::results::fits);
  append(&report::results::verdicts);
  append(&report::results::skipped);
  append(&report::results::densities);
  out.done.work.normals_drawn += more.done.work.normals_drawn;
  out.done.work.path_steps += more.done.work.path_steps;
  out.done.work.kernels_run += more.done.work.kernels_run;
  out.done.results_computed += more.done.results_computed;
}

void report_failures(const experiment& e, const subject& s, const foreign::foreign_schemes& foreign,
                     report::results& out) {
  for (const auto& one : foreign) {
    const auto& name = one->about().name;
    const auto why = one->failure();
    const auto is_it = [&](const scheme_entry& entry) { return entry.info.name == name; };
    if (!why || std::ranges::none_of(s.schemes, is_it) || is_reported(out, name)) continue;
    const auto of_it = [&](const auto& row) { return row.experiment == e.info.name && row.scheme == name; };
    std::erase_if(out.measurements, of_it);
    std::erase_if(out.fits, of_it);
    std::erase_if(out.verdicts, of_it);
    std::erase_if(out.skipped, of_it);
    std::erase_if(out.densities, of_it);
    report::verdict v{.experiment = e.info.name, .scheme = name, .claim = std::string(works)};
    v.kind = report::verdict_kind::refuted;
    v.reason = *why;
    out.verdicts.push_back(v);
  }
}

void agree(const foreign::foreign_schemes& all, const ranks* among) {
  if (among == nullptr) return;
  for (const auto& one : all) {
    if (const auto why = said_by_any(one->failure().value_or(""), *among); !why.empty()) one->fail(why);
    if (const auto why = said_by_any(one->refusal(), *among); !why.empty()) one->refuse(why);
    one->take_as_claimed(of_the_first(one->about().claims, *among));
  }
}

}  // namespace polhode
