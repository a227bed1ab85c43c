// SPDX-License-Identifier: Apache-2.0
// The result of one run over one scene: plain values, written by the experiments, read by the writers.
// Nothing here computes. A number that does not exist is an empty optional with a status, never a NaN.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/model/scene.hpp"
#include "reports/model/work.hpp"

namespace polhode::report {

inline constexpr int schema_version = 2;  ///< of 1 the files can still be read
inline constexpr std::string_view schema_name = "polhode-results";

/// inconclusive: claimed and tried, and not decided, which is never a pass; the reason says what it would take.
/// not_tried: this effort leaves it out by plan. skipped: it does not apply here, or is not claimed.
enum class verdict_kind { holds, refuted, inconclusive, not_tried, skipped };
inline constexpr std::array verdict_kinds{verdict_kind::holds, verdict_kind::refuted, verdict_kind::inconclusive,
                                          verdict_kind::not_tried, verdict_kind::skipped};
constexpr std::string_view name_of(verdict_kind kind) {
  switch (kind) {
    case verdict_kind::holds: return "holds";
    case verdict_kind::refuted: return "refuted";
    case verdict_kind::inconclusive: return "inconclusive";
    case verdict_kind::not_tried: return "not tried";
    case verdict_kind::skipped: return "skipped";
  }
  return "inconclusive";
}

/// Where a result comes from: enough to make it again.
struct provenance {
  std::string version, commit, compiler, flags, cpu;
  std::string isa;        ///< instruction set of the inner loops: v2, v3, v4 (x86-64 levels) or portable
  std::string generator;  ///< of the noise: philox or ars
  int threads = 1;
  std::uint64_t seed = 0;
  std::string effort;
  std::string started;  ///< UTC, ISO 8601
  double wall_seconds = 0, cpu_seconds = 0;
};

/// A scheme and what it claims.
struct scheme {
  std::string name, title, source, calculus;  ///< calculus: "ito" or "stratonovich"
  bool implicit = false, areas = false;
  double strong_commuting = 0, strong_general = 0;  ///< strong order by noise class
  int deterministic_order = 0;                      ///< order for sigma = 0
  bool casimir_exact = false;
  double casimir_order = 0;  ///< order of the Casimir drift; meaningless where exact
  double weak_one_vector = 0, weak_isotropic = 0, weak_general = 0;  ///< weak order by noise class
  // Of one from elsewhere:
  std::string from = {}, takes = {};                          ///< through which door, and what its steps are handed
  std::vector<std::pair<std::string, double>> measured = {};  ///< orders that it does not claim
};

/// Where a number was measured: a step size, a number of steps, a parameter of the scene that was changed for it.
struct coordinate {
  std::string name;
  double value = 0;
  std::string unit = {};
  bool operator==(const coordinate&) const = default;
};
inline constexpr const char *step_size = "dt", *step_count = "steps";

/// What ties measurements, the fit through them, the verdicts that rest on them and their curve in a plot.
struct series_id {
  std::string experiment, scheme, quantity, observable;
  std::string over;  ///< the coordinate that is the abscissa; empty: single numbers
  auto operator<=>(const series_id&) const = default;
};

/// One measured number.
struct measurement {
  std::string experiment = {}, scheme = {}, quantity = {}, observable = {};
  std::optional<double> value = {}, low = {}, high = {};  ///< the estimate and its 95 % interval
  std::string unit = {}, method = {};                     ///< sampled, transfer, exact, reference, deterministic, …
  std::string status = "ok";                              ///< why the value is missing or not used, e.g. "not finite"
  std::vector<coordinate> at = {};
  std::string over = {};  ///< the one of them that is the abscissa of its series
  bool used = false;      ///< in the fit of its series

  series_id series() const { return {experiment, scheme, quantity, observable, over}; }
  std::optional<double> at_coordinate(std::string_view name) const;
  std::optional<double> dt() const { return at_coordinate(step_size); }
  std::optional<double> abscissa() const { return at_coordinate(over); }
  /// One more coordinate, the abscissa from now on.
  void set_over(coordinate);
};

/// log2(value) against log2(abscissa): value = prefactor * abscissa^order.
struct fit {
  std::string experiment, scheme, quantity, observable;
  std::string over = step_size;
  double order = 0, low = 0, high = 0, prefactor = 0;
  std::string rule = {};  ///< which levels were kept, and why the others were not

  series_id series() const { return {experiment, scheme, quantity, observable, over}; }
};

struct verdict {
  std::string experiment = {}, scheme = {}, claim = {};
  std::optional<double> expected = {}, estimate = {}, low = {}, high = {};
  verdict_kind kind = verdict_kind::inconclusive;
  std::string reason = {};
  std::vector<series_id> evidence = {};  ///< what was measured for it; known where a series decides it
};

/// A density on the sphere of directions relative to the uniform one, in bins of equal area: [height][longitude], rows
/// of equal z from z = -1, longitudes from -pi.
struct density {
  std::string experiment, scheme, name;
  std::optional<double> time;
  int longitudes = 0, heights = 0;
  std::vector<double> values;
};

/// What processes that share an experiment tell each other of its noise: how far its sums lie from their law. In no
/// report.
struct audited_noise {
  struct deviation {
    std::string what;
    double z = 0;  ///< in standard errors
  };
  std::string experiment, part;
  std::string scheme = {};           ///< whose it is; empty: all draw the same, one further than another
  double increments = 0, areas = 0;  ///< heard, a channel or pair
  std::vector<deviation> of_increments = {}, of_areas = {};
};

/// What an experiment asks, in one sentence, and what it states about its own method.
struct experiment {
  std::string name, question;
  std::vector<std::string> notes;
};

struct results {
  report::provenance provenance;
  report::scene scene;
  std::vector<report::scheme> schemes;
  std::vector<report::experiment> experiments;
  std::vector<measurement> measurements;
  std::vector<fit> fits;
  std::vector<verdict> verdicts;
  std::vector<skip> skipped;
  std::vector<saving> savings;
  std::vector<reuse> reused;
  std::vector<density> densities;
  work_done done;
  std::vector<std::string> to_come;  ///< experiments that a run has before it; of a finished one: none
  std::vector<audited_noise> audits;
  std::vector<profile_row> profile;  ///< of this run, if it was taken: not of what came from the cache
};

}  // namespace polhode::report
