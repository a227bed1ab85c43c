// Fresh seeds of the cheap sampled experiments: no true claim is refuted, and printed intervals cover what they claim.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <string>

#include "ensemble/paths.hpp"
#include "registry/scene.hpp"
#include "registry/verify.hpp"

namespace polhode {
namespace {

/// One thousand, or as the environment says (POLHODE_SEEDS).
int seeds() {
  const char* wanted = std::getenv("POLHODE_SEEDS");
  return wanted ? std::atoi(wanted) : 1000;
}

/// Calls with(results) of a run on one thread for every seed from `first` on, one at a time.
void over_seeds(std::uint64_t first, const std::vector<std::string>& schemes,
                const std::vector<std::string>& experiments, const std::function<void(const report::results&)>& with) {
  const auto scene = load_scene("paper");
  std::mutex one;
  parallel_for(2, seeds(), [&](int i) {
    verify_options options;
    options.schemes = schemes;
    options.experiments = experiments;
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

// Strong orders and their limit, of all schemes. The long-run mean stands for the truth of a printed order: it is what
// the fit estimates at these dt, its own mean error being a thirtieth of a seed's interval.
TEST(FreshSeeds, RefuteNoStrongClaimAndOrdersCoverTheirMean) {
  alarm_counter alarms;
  std::map<std::string, interval_record> orders;
  over_seeds(10'001, {}, {"strong"}, [&](const report::results& r) {
    alarms.add(r);
    for (const auto& f : r.fits) orders[f.scheme + ", " + f.quantity].add(f.order, f.low, f.high);
  });
  alarms.print();
  std::printf("| scheme, error | mean order | covered |\n|---|---|---|\n");
  for (const auto& [what, o] : orders) {
    const auto [low, high] = share_interval(o.covering(o.mean()), o.count());
    std::printf("| %s | %.4f | %.3f [%.3f, %.3f] |\n", what.c_str(), o.mean(),
                o.covering(o.mean()) / static_cast<double>(o.count()), low, high);
    EXPECT_TRUE(high >= 0.93 && low <= 0.97) << what << ": coverage in [" << low << ", " << high << "]";
  }
}

TEST(FreshSeeds, RefuteNoCasimirClaim) {
  alarm_counter alarms;
  over_seeds(20'001, {"euler_maruyama", "heun", "milstein", "milstein_no_area"}, {"casimir"},
             [&](const report::results& r) { alarms.add(r); });
  alarms.print();
}

TEST(FreshSeeds, RefuteNoStationaryLaw) {
  alarm_counter alarms;
  over_seeds(30'001, {"lie_heun", "strang", "strang_weak2"}, {"gibbs"},
             [&](const report::results& r) { alarms.add(r); });
  alarms.print();
}

}  // namespace
}  // namespace polhode
