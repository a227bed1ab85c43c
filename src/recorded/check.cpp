// SPDX-License-Identifier: Apache-2.0
#include "recorded/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "ensemble/model.hpp"
#include "experiments/common/experiment.hpp"
#include "experiments/common/recorder.hpp"
#include "problem/observables.hpp"
#include "recorded/claims.hpp"
#include "recorded/recorded_law.hpp"
#include "recorded/transition_report.hpp"
#include "recorded/transitions.hpp"
#include "reports/model/errors.hpp"

namespace polhode {
namespace {

// How far recorded states are from the coadjoint orbit on which their path began.

class casimir_drift {
 public:
  explicit casimir_drift(const model&);

  void add(const recorded_transition&);
  /// resolution: of a number of the file, relative. What so many digits hide is no drift.
  void report(double resolution, recorder&) const;

 private:
  const model& model_;
  std::vector<double> largest_;  ///< change over size, of each Casimir
  std::vector<double> sum_;      ///< of the changes, of each: a drift has a sign
  double count_ = 0;
};

constexpr double rounding = 1e-11;    // of a Casimir: long runs of schemes that keep it
constexpr double of_one_number = 16;  // a Casimir is made of products of several

casimir_drift::casimir_drift(const model& m) : model_(m) {}

void casimir_drift::add(const recorded_transition& t) {
  const auto start = model_.casimirs(t.start), now = model_.casimirs(t.after), size = model_.casimir_sizes(t.start);
  largest_.resize(start.size());
  sum_.resize(start.size());
  for (std::size_t k = 0; k < start.size(); ++k) {
    const double change = (now[k] - start[k]) / size[k];
    largest_[k] = std::max(largest_[k], std::fabs(change));
    sum_[k] += change;
  }
  ++count_;
}

void casimir_drift::report(double resolution, recorder& record) const {
  const double allowed = rounding + of_one_number * resolution;
  double worst = 0, mean = 0;
  for (std::size_t k = 0; k < largest_.size(); ++k) {
    const auto name = largest_.size() == 1 ? std::string("casimir") : fmt::format("casimir_{}", k + 1);
    record.value({"largest relative change", name, "", "recorded"}, largest_[k]);
    if (largest_[k] < worst) continue;
    worst = largest_[k];
    mean = sum_[k] / count_;
  }
  report::verdict v{.expected = 0, .estimate = worst, .low = 0, .high = allowed};
  v.kind = worst <= allowed ? report::verdict_kind::holds : report::verdict_kind::refuted;
  v.reason = fmt::format("largest relative change along a path {:.2g}, {:.2g} on average; {:.2g} is what {} hide",
                         worst, mean, allowed, resolution <= 0x1p-52 ? "rounding may" : "the digits of the file");
  record.verdict(recorded_claim::casimir, std::move(v));
}

std::vector<std::string> names_of_components(const subject& s) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < s.scene.momentum.size(); ++k) names.push_back(component_name(s, k));
  return names;
}

std::string read_from(const transitions& pairs, std::uint64_t states) {
  std::string out = fmt::format("Read: {} states of {} paths, {} intervals", states, pairs.paths(), pairs.count());
  for (const auto& [interval, count] : pairs.intervals())
    out += fmt::format("{} {} of {:g}", out.ends_with("intervals") ? ":" : ",", count, interval);
  return out + ".";
}

void report_elsewhere(recorder& record) {
  for (const char* claim : {recorded_claim::transition_law, recorded_claim::energy_law, recorded_claim::stationary_law})
    record.verdict(claim, {.kind = report::verdict_kind::skipped, .reason = no_exact_law});
}

}  // namespace

checked_recording check_recording(const subject& s, const std::filesystem::path& file, std::optional<double> dt) {
  const recording from{file, names_of_components(s), dt};
  casimir_drift drift(*s.model);
  std::optional<transition_report> law;
  std::optional<recorded_law> stationary;
  if (s.sphere()) {
    law.emplace(s);
    stationary.emplace(s);
  }
  transitions pairs(from, [&](const recorded_transition& t) {
    drift.add(t);
    if (!law) return;
    law->add(t);
    stationary->add(t);
  });
  const auto size = read_recording(from, [&](const recorded_state& state) { pairs.add(state); });
  if (pairs.count() == 0)
    throw input_error(
        fmt::format("{}: {} states, no two of one path; accepted: two of a path, or more", file.string(), size.states));
  checked_recording out;
  recorder record(recorded_experiment, recorded_scheme, out.results);
  drift.report(size.resolution, record);
  if (law) {
    out.equation = law->report(record);
    stationary->report(record);
  } else {
    report_elsewhere(record);
  }
  out.results.experiments.push_back(
      {recorded_experiment,
       "Do the recorded states follow the scene's equation?",
       {read_from(pairs, size.states),
        fmt::format(
            "Transition law: P = exp(D L) is known exactly for the interval D between states, so [f(X') - (P f)(X)] "
            "g(X) has mean zero and a known conditional variance for any f and g: z-tests over harmonics f up to "
            "degree {} and g up to {}, whatever wrote the data and whatever step it took inside. Their largest "
            "|z|, and their sum of squares by the exact covariance, each with half of the budget of false "
            "alarms, {:g}. A pass would have seen a noise 10 % off.",
            degree_after, degree_before, false_alarms),
        "Parameters that the data follow: the same moment equations solved for the strengths of noise and dissipation "
        "and for the numbers of the energy (generalised method of moments, 95 % intervals from the observed "
        "covariance). A parameter whose effect the ones before it have too is held at the scene's value.",
        "Stationary law: the first five relaxation times of every path are left out, the rest is cut into pieces of "
        "ten; Student's intervals over their means against the exact stationary means."}});
  return out;
}

}  // namespace polhode
