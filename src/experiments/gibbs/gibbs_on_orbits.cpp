// SPDX-License-Identifier: Apache-2.0
#include "experiments/gibbs/gibbs_on_orbits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/noise_verdict.hpp"
#include "experiments/common/recorder.hpp"
#include "experiments/common/sequential.hpp"
#include "experiments/common/undecided.hpp"
#include "experiments/gibbs/gibbs_moments.hpp"
#include "experiments/gibbs/long_runs.hpp"
#include "experiments/gibbs/relaxation.hpp"
#include "problem/observables.hpp"
#include "problem/subject.hpp"

namespace polhode {
namespace {

// The whole law of what a system knows the distribution of (capabilities::gibbs_marginals), from long paths.
//
// Of each path ten values, about two of the longest autocorrelation times apart: as n_eff independent ones, n (1 - r) /
// (1 + r) with r = exp(-1.95), the correlation of neighbours.

/// Of one scheme.
class marginal_samples {
 public:
  static constexpr int draws = 10;  ///< of a path

  marginal_samples(const subject&, int paths);

  /// look: of so many looks at a path, equally far apart, 0 the first; others than every tenth part are passed over.
  void keep(std::span<const double> mu, std::size_t path, int look, int looks);
  /// Kolmogorov-Smirnov distances over the first paths, one a marginal; times_averaged: autocorrelation times of all
  /// looks at a path.
  std::vector<interval_estimate> distances(int paths, double times_averaged) const;

 private:
  const std::vector<known_marginal>& laws_;
  std::vector<std::vector<double>> values_;  ///< [marginal][path, draw]
};

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

/// By widths alone: half the bound.
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

// Means of a scheme's long paths against those that a system knows of its Gibbs law.

struct known_mean {
  double exact, deviation;  ///< of the observable under the law
  double margin() const { return moment_margin * deviation; }
};

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

/// Of energy, of components, of squares: a claim holds if it holds of each of its means; the mean that decides is
/// named. found: intervals of the means, one an observable.
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

constexpr double orbit_forgetting = 10, orbit_averaging = 20;  // autocorrelation times
constexpr int orbit_looks = 256;                               // at a path while it is averaged
constexpr double tight_averages = 1.0 / 3;                     // of a margin: the half-width at which sampling stops

struct orbit_design {
  double dt = 0;
  std::int64_t burn = 0, spacing = 0;  ///< in steps
  std::vector<observable> observables = {};
  std::vector<known_mean> means = {};
  double steps() const { return static_cast<double>(burn + orbit_looks * spacing); }
};

/// Of what the system knows the mean, and of what scatters at all.
orbit_design design_for(const subject& s, double dt, const std::vector<observable>& all, const relaxation& found) {
  const auto steps = [&](double times) { return static_cast<std::int64_t>(std::ceil(times * found.time / dt)); };
  orbit_design out{.dt = dt, .burn = steps(orbit_forgetting), .spacing = steps(orbit_averaging / orbit_looks)};
  for (std::size_t f = 0; f < all.size(); ++f) {
    const auto law = s.offers->gibbs_mean(all[f].name);
    const known_mean mean{law && law->value ? *law->value : NAN, found.deviation[f]};
    const double size = std::fabs(mean.exact) + mean.deviation;
    if (!std::isfinite(mean.exact) || mean.deviation <= 1e-9 * size || law->uncertainty > 0.01 * mean.margin())
      continue;
    out.observables.push_back(all[f]);
    out.means.push_back(mean);
  }
  return out;
}

/// Of one scheme.
struct sample {
  std::vector<std::vector<double>> averages;  ///< in time: [observable][path]
  marginal_samples values;
};
struct finding {
  std::vector<interval_estimate> means, distances;
};

void run_orbits(const context& c, const orbit_design& d, std::span<const scheme_entry> schemes,
                std::span<const std::unique_ptr<kernel>> kernels, std::span<const int> open, int block,
                std::vector<sample>& out, noise_log& log) {
  constexpr std::int64_t chunk = 200;
  const std::vector<std::size_t> indices(open.begin(), open.end());
  const bool areas = std::ranges::any_of(indices, [&](std::size_t k) { return schemes[k].needs_areas; });
  increment_buffer noise(*c.subject.model, chunk, areas, {c.generator, noise_quality::fast});
  const auto first_path = static_cast<std::uint64_t>(block * block_lanes);
  auto [start, step] = spread_start(c, d.dt, first_path, &log, block);
  std::vector<std::vector<double>> states(kernels.size(), start);
  const auto advance = [&](std::int64_t steps) {
    for (std::int64_t left = steps; left > 0; left -= chunk) {
      const int n = static_cast<int>(std::min(left, chunk));
      const auto view = noise.fill(c.seed, first_path, step, n, d.dt);
      log.add(block, view, d.dt);
      for (const auto k : indices) kernels[k]->advance(states[k], view);
      step += static_cast<std::uint64_t>(n);
    }
  };
  advance(d.burn);
  for (int i = 0; i < orbit_looks; ++i) {
    advance(d.spacing);
    for (const auto k : indices)
      for (int lane = 0; lane < block_lanes; ++lane) {
        const auto mu = lane_of(states[k], lane, c.subject.model->dimension());
        for (std::size_t f = 0; f < d.observables.size(); ++f)
          out[k].averages[f][first_path + static_cast<std::size_t>(lane)] += d.observables[f].value(mu) / orbit_looks;
        out[k].values.keep(mu, first_path + static_cast<std::size_t>(lane), i, orbit_looks);
      }
  }
}

finding find(const sample& s, int paths) {
  finding out{{}, s.values.distances(paths, orbit_averaging)};
  for (const auto& f : s.averages)
    out.means.push_back(mean_interval(std::span(f).first(static_cast<std::size_t>(paths))));
  return out;
}

bool tight(const orbit_design& d, const finding& found) {
  for (std::size_t f = 0; f < found.means.size(); ++f)
    if (!(half_width(found.means[f]) <= tight_averages * d.means[f].margin())) return false;
  return tight_distances(found.distances);
}

void report_orbits(const context& c, const std::vector<scheme_entry>& schemes, const orbit_design& d,
                   const sampling_plan& paths, report::results& out) {
  std::vector<std::unique_ptr<kernel>> kernels;
  for (const auto& e : schemes) kernels.push_back(e.make(d.dt));
  const std::vector<double> room(static_cast<std::size_t>(blocks_of(paths.most) * block_lanes));
  std::vector<sample> samples(kernels.size(), {std::vector(d.observables.size(), room),
                                               marginal_samples(c.subject, static_cast<int>(room.size()))});
  noise_log log(*c.subject.model, blocks_of(paths.most));
  std::vector<finding> found(kernels.size());
  const auto sizes = sample_until_tight(
      c, paths, static_cast<int>(kernels.size()),
      [&](int block, std::span<const int> open) { run_orbits(c, d, schemes, kernels, open, block, samples, log); },
      [&](int scheme, int so_far) {
        const auto k = static_cast<std::size_t>(scheme);
        found[k] = find(samples[k], so_far);
        return tight(d, found[k]);
      });
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    recorder record("gibbs", schemes[k].info.name, out);
    report_known_means(d.observables, d.means, d.dt, found[k].means, record);
    report_marginals(c.subject, d.dt, found[k].distances, record);
    record.remark(sizes[k].text());
  }
  log.report("gibbs", out);
}

}  // namespace

void report_sampled_means(const context& c, report::results& out) {
  if (const auto reason = no_gibbs_means(c.subject)) {
    out.skipped.push_back({"gibbs", "", "sampled law: " + *reason});
    return;
  }
  std::vector<scheme_entry> schemes;
  std::ranges::copy_if(c.subject.schemes, std::back_inserter(schemes),
                       [](const scheme_entry& e) { return e.info.casimir.exact; });
  const auto affordable = [](effort e) { return by_effort(e, 1e5, 4e5, 2e6); };
  const sampling_plan paths{128, by_effort(c.effort, 512, 2048, 8192)};
  const double dt = 0.04 / fastest_rate(c.subject);
  const auto all = observables_of(c.subject, averaged_components);
  const auto start =
      relaxation_of(c, all, dt, affordable(c.effort), static_cast<std::uint64_t>(blocks_of(paths.most) * block_lanes));
  if (!start.reason.empty())
    return leave_open(schemes, "gibbs", "mean of energy", "the start is not forgotten: " + start.reason, out);
  const auto d = design_for(c.subject, dt, all, start);
  const dear_claim law{"gibbs",        "mean of energy", "forgetting the start and averaging",
                       "steps a path", d.steps(),        affordable};
  if (affords(c, schemes, law, out)) report_orbits(c, schemes, d, paths, out);
}

}  // namespace polhode
