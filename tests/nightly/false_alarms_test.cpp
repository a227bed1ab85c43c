// SPDX-License-Identifier: Apache-2.0
// Fresh seeds of the cheap sampled experiments: no true claim is refuted, and printed intervals cover what they claim.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/beta.hpp>
#include <cmath>
#include <cstdio>
#include <map>
#include <mutex>
#include <string>

#include "ensemble/noise/paths.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "support/from_environment.hpp"

namespace polhode {
namespace {

/// One thousand, or as the environment says (POLHODE_SEEDS).
int seeds() { return test::from_environment("POLHODE_SEEDS", 1000); }

/// Calls with(results) of a run on one thread for every seed from `first` on, one at a time.
void over_seeds(const std::string& name, std::uint64_t first, const std::vector<std::string>& schemes,
                const std::string& experiment, const std::function<void(const report::results&)>& with) {
  const auto scene = load_scene(name);
  std::mutex one;
  parallel_for(2, seeds(), [&](int i) {
    verify_options options;
    options.schemes = schemes;
    options.experiments = {experiment};
    options.effort = effort::quick;
    options.seed = first + static_cast<std::uint64_t>(i);
    const auto r = verify(scene, options);
    const std::lock_guard lock(one);
    with(r);
  });
}

struct verdict_counts {
  int holds = 0, refuted = 0, inconclusive = 0;
};

/// Counts verdicts by experiment and claim; a refuted one is a failure.
class alarm_counter {
 public:
  void add(const report::results& r) {
    for (const auto& v : r.verdicts) {
      auto& c = counts_[v.experiment + ": " + v.claim];
      c.holds += v.kind == report::verdict_kind::holds;
      c.inconclusive += v.kind == report::verdict_kind::inconclusive;
      if (v.kind != report::verdict_kind::refuted) continue;
      ++c.refuted;
      ADD_FAILURE() << "seed " << r.provenance.seed << ", " << v.scheme << ": " << v.claim << ": " << v.reason;
    }
  }
  /// An experiment that says nothing raises no alarm either: some claim has to hold.
  void judge() const {
    int holding = 0;
    for (const auto& [_, c] : counts_) holding += c.holds;
    EXPECT_GT(holding, 0);
  }
  void print() const {
    std::printf("| claim | holds | inconclusive | refuted |\n|---|---|---|---|\n");
    for (const auto& [claim, c] : counts_)
      std::printf("| %s | %d | %d | %d |\n", claim.c_str(), c.holds, c.inconclusive, c.refuted);
  }

 private:
  std::map<std::string, verdict_counts> counts_;
};

/// Printed intervals of one number over many seeds.
class interval_record {
 public:
  void add(double value, double low, double high) { all_.push_back({value, low, high}); }
  double mean() const {
    double sum = 0;
    for (const auto& i : all_) sum += i.value;
    return sum / static_cast<double>(all_.size());
  }
  bool varies() const {
    const auto [least, most] = std::ranges::minmax_element(all_, {}, &interval::value);
    return most->value - least->value > 1e-9 * std::fabs(most->value);
  }
  int covering(double truth) const {
    return static_cast<int>(
        std::ranges::count_if(all_, [=](const auto& i) { return i.low <= truth && truth <= i.high; }));
  }
  int count() const { return static_cast<int>(all_.size()); }

 private:
  struct interval {
    double value, low, high;
  };
  std::vector<interval> all_;
};

/// Clopper and Pearson's interval of a share, 99 %.
std::pair<double, double> share_interval(int hits, int of) {
  using boost::math::beta_distribution;
  const double low = hits == 0 ? 0 : quantile(beta_distribution<>(hits, of - hits + 1), 0.005);
  const double high = hits == of ? 1 : quantile(beta_distribution<>(hits + 1, of - hits), 0.995);
  return {low, high};
}

/// How often intervals cover what they claim, by experiment and quantity. The mean over all seeds stands for the truth:
/// its own error is small beside a seed's interval. But of a distance between laws: of a sample it is never zero, and
/// of the laws themselves, far below the band here, it is.
class coverage_record {
 public:
  static constexpr std::array distances_of_laws{"ks_distance", "distance to its own law"};
  /// The range in which single paths lie is no interval of a mean.
  static constexpr const char* spread_of_paths = "slope of single paths";

  /// Fitted orders, and every number that is drawn and has an interval.
  void add(const report::results& r) {
    for (const auto& f : r.fits)
      add({f.experiment, "order of " + f.quantity}, f.scheme + f.observable, f.order, f.low, f.high);
    for (const auto& m : r.measurements)
      if (m.method == "sampled" && m.quantity != spread_of_paths && m.value && m.low && m.high && *m.low < *m.high)
        add({m.experiment, m.quantity},
            fmt::format("{} {} {} {}", m.scheme, m.observable, m.dt().value_or(0), m.abscissa().value_or(0)), *m.value,
            *m.low, *m.high);
  }

  /// The rows of one kind are of the same paths, so that there are no more independent cases than seeds.
  void judge() const {
    std::printf("| experiment, interval | rows | covered |\n|---|---|---|\n");
    int judged = 0;
    for (const auto& [kind, rows] : kinds_) {
      const bool is_distance = std::ranges::find(distances_of_laws, kind.second) != distances_of_laws.end();
      double share = 0;
      int seeds = 0, counted = 0;
      for (const auto& [_, row] : rows) {
        if (2 * row.count() < polhode::seeds() || !row.varies()) continue;  // not in every run, or not drawn
        share += row.covering(is_distance ? 0 : row.mean()) / static_cast<double>(row.count());
        seeds = std::max(seeds, row.count());
        ++counted;
      }
      if (counted == 0) continue;
      ++judged;
      share /= counted;
      const auto [low, high] = share_interval(static_cast<int>(std::lround(share * seeds)), seeds);
      std::printf("| %s, %s | %d | %.3f [%.3f, %.3f] |\n", kind.first.c_str(), kind.second.c_str(), counted, share, low,
                  high);
      EXPECT_TRUE(high >= 0.93 && low <= 0.97) << kind.first << ", " << kind.second;
    }
    EXPECT_GT(judged, 0) << "no interval was drawn";
  }

 private:
  using interval_kind = std::pair<std::string, std::string>;
  void add(const interval_kind& k, const std::string& row, double value, double low, double high) {
    kinds_[k][row].add(value, low, high);
  }
  std::map<interval_kind, std::map<std::string, interval_record>> kinds_;
};

void hold_on_fresh_seeds(const std::string& scene, std::uint64_t first, const std::vector<std::string>& schemes,
                         const std::string& experiment) {
  alarm_counter alarms;
  coverage_record intervals;
  over_seeds(scene, first, schemes, experiment, [&](const report::results& r) {
    alarms.add(r);
    intervals.add(r);
  });
  alarms.print();
  alarms.judge();
  intervals.judge();
}

const std::vector<std::string> on_the_orbit{"lie_heun", "strang", "strang_weak2"};

TEST(FreshSeeds, Strong) { hold_on_fresh_seeds("paper", 10'001, {}, "strong"); }

TEST(FreshSeeds, Casimir) {
  hold_on_fresh_seeds("paper", 20'001, {"euler_maruyama", "heun", "milstein", "milstein_no_area"}, "casimir");
}

TEST(FreshSeeds, Gibbs) { hold_on_fresh_seeds("paper", 30'001, on_the_orbit, "gibbs"); }

TEST(FreshSeeds, GibbsOnAnOrbit) { hold_on_fresh_seeds("so4", 40'001, on_the_orbit, "gibbs"); }

TEST(FreshSeeds, Weak) { hold_on_fresh_seeds("so4", 50'001, {"heun", "lie_heun", "strang"}, "weak"); }

TEST(FreshSeeds, Lyapunov) { hold_on_fresh_seeds("so4", 60'001, on_the_orbit, "lyapunov"); }

TEST(FreshSeeds, LyapunovOnASphere) { hold_on_fresh_seeds("paper", 70'001, on_the_orbit, "lyapunov"); }

TEST(FreshSeeds, Attractor) { hold_on_fresh_seeds("paper", 80'001, on_the_orbit, "attractor"); }

TEST(FreshSeeds, AttractorOffTheSphere) { hold_on_fresh_seeds("heavy_top", 90'001, on_the_orbit, "attractor"); }

}  // namespace
}  // namespace polhode
