#include "experiments/lyapunov_sampled.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "experiments/judge.hpp"
#include "experiments/levels.hpp"
#include "experiments/sequential.hpp"
#include "experiments/tangent_runs.hpp"
#include "experiments/transfer.hpp"
#include "experiments/undecided.hpp"
#include "statistics/control_variates.hpp"

namespace polhode {
namespace {

constexpr double fineness = 128;       // steps per fastest time scale where exponents are compared
constexpr double margin_share = 1e-3;  // of the fastest rate: how far an exponent may lie
constexpr double tight_value = 0.35;   // of the margin: the half-width at which sampling stops
constexpr double known_share = 0.1;    // of the margin: how uncertain an exact value may be
constexpr double relaxations = 8;      // until the start is forgotten, to e^-8
constexpr double observed = 5;         // times as long as that
constexpr const char* length_claim = "finds lambda_1";

/// The growth along paths of each scheme, sampled until the intervals are tight.
class sampled_growth {
 public:
  sampled_growth(const context& c, const std::vector<scheme_entry>& schemes, const run_length& run)
      : context_(c), schemes_(schemes), run_(run) {}

  void sample(const sampling_plan& plan, double tight) {
    const int paths = blocks_of(plan.most) * block_lanes;
    for (const auto& scheme : schemes_) {
      found_.emplace_back(paths);
      kernels_.push_back(scheme.tangent(run_.dt));
    }
    log_.emplace(*context_.subject.model, blocks_of(plan.most));
    sizes_ = sample_until_tight(
        context_, plan, static_cast<int>(schemes_.size()),
        [&](int block, std::span<const int> open) { run(block, open); },
        [&](int scheme, int so_far) { return is_tight(static_cast<std::size_t>(scheme), so_far, tight); });
  }

  void report_noise(report::results& out) const { log_->report("lyapunov", out); }
  /// With the noise that the controls take out: their means are zero if the noise has its law, and only then does
  /// taking them out change nothing but the variance.
  interval_estimate raw_mean(std::size_t scheme, Eigen::VectorXd growth::*what, int paths) const {
    const Eigen::VectorXd all = (found_[scheme].*what).head(paths);
    return mean_interval({all.data(), static_cast<std::size_t>(all.size())});
  }
  control_means controls(std::size_t scheme, int paths) const {
    return means_of_controls(found_[scheme].control.topRows(paths));
  }
  const sample_size& size(std::size_t scheme) const { return sizes_[scheme]; }

  /// Without the noise that can be taken out.
  interval_estimate mean(std::size_t scheme, Eigen::VectorXd growth::*what, int paths) const {
    const auto& g = found_[scheme];
    const auto all = controlled((g.*what).head(paths), g.control.topRows(paths));
    return mean_interval({all.data(), static_cast<std::size_t>(all.size())});
  }

 private:
  void run(int block, std::span<const int> open) {
    std::vector<const tangent_kernel*> kernels;
    std::vector<growth*> out;
    bool areas = false;
    for (const int k : open) {
      const auto i = static_cast<std::size_t>(k);
      kernels.push_back(kernels_[i].get());
      out.push_back(&found_[i]);
      areas = areas || schemes_[i].needs_areas;
    }
    run_tangents(context_, run_, block, kernels, areas, out, &*log_);
  }
  bool is_tight(std::size_t scheme, int paths, double tight) const {
    for (const auto what : {&growth::length, &growth::area})
      if (!(half_width(mean(scheme, what, paths)) <= tight)) return false;
    return true;
  }

  const context& context_;
  const std::vector<scheme_entry>& schemes_;
  run_length run_;
  std::vector<growth> found_;                             // [scheme]
  std::vector<std::unique_ptr<tangent_kernel>> kernels_;  // the same
  std::vector<sample_size> sizes_;
  std::optional<noise_log> log_;
};

struct exponent {
  std::string name;
  Eigen::VectorXd growth::*values;
  std::optional<double> exact;  // empty: nothing to compare with
  double uncertainty;
};

void report_exponent(const exponent& e, const std::string& scheme, double dt, const interval_estimate& found,
                     double margin, report::results& out) {
  out.measurements.push_back(
      measured({"lyapunov", scheme, e.name, "", "per time", "sampled"}, dt, found.value, found.low, found.high));
  if (!e.exact) return;
  report::verdict v{"lyapunov", scheme, "finds " + e.name, e.exact, {}, {}, {}, report::verdict_kind::inconclusive, ""};
  if (std::isfinite(found.value)) {
    v.estimate = found.value;
    v.low = found.low;
    v.high = found.high;
    v.kind = judge(*e.exact, found.low, found.high, margin - e.uncertainty);
    v.reason = fmt::format("[{:.6f}, {:.6f}] at dt = {:.3g} against {:.6f} +- {:.2g}", found.low, found.high, dt,
                           *e.exact, margin);
  } else {
    v.reason = "not finite: a step of the scheme fails";
  }
  out.verdicts.push_back(v);
}

void report_controls(const std::string& scheme, const control_means& found, report::results& out) {
  report::verdict v{"lyapunov",
                    scheme,
                    "controls have mean zero",
                    0.0,
                    {},
                    {},
                    {},
                    report::verdict_kind::inconclusive,
                    "not finite: a step of the scheme fails"};
  if (std::isfinite(found.largest)) {
    const double limit = audit_threshold(static_cast<std::size_t>(found.count));
    v.estimate = found.largest;
    v.kind = std::fabs(found.largest) <= limit ? report::verdict_kind::holds : report::verdict_kind::refuted;
    v.reason = fmt::format("the largest of {} means is {:.1f} standard errors from zero, at most {:.1f}", found.count,
                           found.largest, limit);
  }
  out.verdicts.push_back(v);
}

/// Of each path until it is observed; empty, and the report says why, if that is unknown or too long.
std::optional<double> time_to_forget(const context& c, std::span<const scheme_entry> schemes, double rate,
                                     report::results& out) {
  const auto p = *sphere_problem_of(c.subject);
  const auto gap = spectral_gap(p, 1e-3 * p.covariance.trace());
  if (!gap.converged()) {
    leave_open(schemes, "lyapunov", length_claim,
               "how long a start is remembered is not known: the spectral gap is " + gap.reason, out);
    return std::nullopt;
  }
  if (!(*gap.value > 0)) {
    out.skipped.push_back(
        {"lyapunov", "", "sampled exponents: the start is never forgotten: no stationary law is unique"});
    return std::nullopt;
  }
  const double time = relaxations / *gap.value;
  const bool affordable =
      affords(c, schemes,
              {"lyapunov", length_claim, "forgetting the start", "steps a path",
               (1 + observed) * time * fineness * rate, [](effort e) { return by_effort(e, 1e5, 2e5, 2e6); }},
              out);
  return affordable ? std::optional(time) : std::nullopt;
}

}  // namespace

void report_sampled_exponents(const context& c, const std::vector<scheme_entry>& schemes,
                              const lyapunov_exponents& exact, report::results& out) {
  const double rate = fastest_rate(c.subject), margin = margin_share * rate;
  const auto forgotten = time_to_forget(c, schemes, rate, out);
  if (!forgotten) return;
  const bool known = exact.lambda1 && std::max(exact.uncertainty, exact.sum_uncertainty) <= known_share * margin;
  if (!known) leave_open(schemes, "lyapunov", length_claim, "lambda_1 itself is " + exact.reason, out);
  const auto if_known = [&](double x) { return known ? std::optional(x) : std::nullopt; };
  const exponent exponents[]{{"lambda_1", &growth::length, if_known(exact.lambda1.value_or(0)), exact.uncertainty},
                             {"lambda_1 + lambda_2", &growth::area, if_known(exact.sum), exact.sum_uncertainty}};
  const auto run = run_length_of(1 / (fineness * rate), *forgotten, observed * *forgotten);
  sampled_growth sampled(c, schemes, run);
  sampled.sample({256, by_effort(c.effort, 1024, 2048, 4096)}, tight_value * margin);
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    const std::string name(schemes[k].info.name);
    const int paths = sampled.size(k).used;
    for (const auto& e : exponents) {
      report_exponent(e, name, run.dt, sampled.mean(k, e.values, paths), margin, out);
      const auto raw = sampled.raw_mean(k, e.values, paths);
      out.measurements.push_back(measured({"lyapunov", name, e.name + ", no controls", "", "per time", "sampled"},
                                          run.dt, raw.value, raw.low, raw.high));
    }
    report_controls(name, sampled.controls(k, paths), out);
    note_sample_size(out, "lyapunov", schemes[k].info.name, sampled.size(k));
  }
  sampled.report_noise(out);
}

}  // namespace polhode
