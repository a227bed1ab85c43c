// SPDX-License-Identifier: Apache-2.0
#include "experiments/common/undecided.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "experiments/common/recorder.hpp"

namespace polhode {
namespace {

constexpr std::array efforts{effort::quick, effort::standard, effort::thorough};
constexpr std::array names{"quick", "standard", "thorough"};

void add_verdicts(std::span<const scheme_entry> schemes, std::string_view experiment, std::string_view claim,
                  report::verdict_kind kind, const std::string& reason, report::results& out) {
  for (const auto& scheme : schemes)
    recorder(experiment, scheme.info.name, out).verdict(std::string(claim), {.kind = kind, .reason = reason});
}

}  // namespace

void leave_open(std::span<const scheme_entry> schemes, std::string_view experiment, std::string_view claim,
                const std::string& reason, report::results& out) {
  add_verdicts(schemes, experiment, claim, report::verdict_kind::inconclusive, reason, out);
}

void leave_untried(std::span<const scheme_entry> schemes, std::string_view experiment, std::string_view claim,
                   const std::string& reason, report::results& out) {
  add_verdicts(schemes, experiment, claim, report::verdict_kind::not_tried, reason, out);
}

bool affords(const context& c, std::span<const scheme_entry> schemes, const dear_claim& d, report::results& out) {
  const auto affordable = [&](effort e) { return d.work <= d.affordable(e); };
  if (affordable(c.effort)) return true;
  const auto needed =
      fmt::format("{} takes {:.2g} {}, at most {:.2g} are affordable", d.what, d.work, d.unit, d.affordable(c.effort));
  const auto enough = std::ranges::find_if(efforts, affordable);
  if (enough != efforts.end())
    leave_untried(
        schemes, d.experiment, d.claim,
        fmt::format("{}; tried at effort {}", needed, names[static_cast<std::size_t>(enough - efforts.begin())]), out);
  else
    leave_open(schemes, d.experiment, d.claim,
               fmt::format("{}, {:.2g} at effort thorough", needed, d.affordable(effort::thorough)), out);
  return false;
}

}  // namespace polhode
