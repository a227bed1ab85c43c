#include "experiments/lyapunov_sampled.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "experiments/judge.hpp"
#include "experiments/levels.hpp"
#include "experiments/progress_counter.hpp"
#include "experiments/sequential.hpp"
#include "experiments/tangent_runs.hpp"
#include "experiments/transfer.hpp"
#include "experiments/transfer_report.hpp"
#include "statistics/control_variates.hpp"
#include "statistics/order_fit.hpp"

namespace polhode {
namespace {

constexpr std::array fine{128.0};  // steps per fastest time scale where exponents are compared
constexpr std::array coarse{1.0, 2.0, 4.0, 8.0, 16.0, 32.0};  // where the order is looked for
constexpr double margin_share = 1e-3;                         // of the fastest rate: how far an exponent may lie
constexpr double tight_value = 0.35;                          // of the margin: the half-width at which sampling stops
constexpr double tight_error = 1.0 / 60;                      // the same where errors are to be resolved
constexpr double known_share = 0.1;                           // of the margin: how uncertain an exact value may be
constexpr double clear = 5;                                   // standard errors: an error that a fit may use
constexpr double relaxations = 8;                             // until the start is forgotten, to e^-8
constexpr double observed = 5, observed_thoroughly = 40;      // times as long as that

/// Several step sizes, sampled until their intervals are tight.
class sampled_levels {
 public:
  sampled_levels(const context& c, const std::vector<scheme_entry>& schemes, std::vector<run_length> runs,
                 int first_level)
      : context_(c), schemes_(schemes), runs_(std::move(runs)), first_level_(first_level) {}

  void sample(const sampling_plan& plan, double tight) {
    const int paths = blocks_of(plan.most) * block_lanes;
    for (const auto& scheme : schemes_) {
      found_.emplace_back(runs_.size(), growth(paths));
      kernels_.emplace_back();
      for (const auto& run : runs_) kernels_.back().push_back(scheme.tangent(run.dt));
    }
    sizes_ = sample_until_tight(
        context_, plan, static_cast<int>(schemes_.size()),
        [&](int block, std::span<const int> open) { run(block, open); },
        [&](int scheme, int so_far) { return is_tight(static_cast<std::size_t>(scheme), so_far, tight); });
  }

  std::vector<double> dt() const {
    std::vector<double> out;
    for (const auto& run : runs_) out.push_back(run.dt);
    return out;
  }
  const sample_size& size(std::size_t scheme) const { return sizes_[scheme]; }

  /// Of each path, without the noise that can be taken out.
  Eigen::VectorXd values(std::size_t scheme, std::size_t level, Eigen::VectorXd growth::*what, int paths) const {
    const auto& g = found_[scheme][level];
    return controlled((g.*what).head(paths), g.control.topRows(paths));
  }
  interval_estimate mean(std::size_t scheme, std::size_t level, Eigen::VectorXd growth::*what, int paths) const {
    const auto all = values(scheme, level, what, paths);
    return mean_interval({all.data(), static_cast<std::size_t>(all.size())});
  }

 private:
  void run(int block, std::span<const int> open) {
    const bool areas =
        std::ranges::any_of(open, [&](int k) { return schemes_[static_cast<std::size_t>(k)].needs_areas; });
    for (std::size_t l = 0; l < runs_.size(); ++l) {
      std::vector<const tangent_kernel*> kernels;
      std::vector<growth*> out;
      for (const int k : open) {
        kernels.push_back(kernels_[static_cast<std::size_t>(k)][l].get());
        out.push_back(&found_[static_cast<std::size_t>(k)][l]);
      }
      run_tangents(context_, runs_[l], first_level_ + static_cast<int>(l), block, kernels, areas, out);
    }
  }
  bool is_tight(std::size_t scheme, int paths, double tight) const {
    for (std::size_t l = 0; l < runs_.size(); ++l)
      for (const auto what : {&growth::length, &growth::area})
        if (!(half_width(mean(scheme, l, what, paths)) <= tight)) return false;
    return true;
  }

  const context& context_;
  const std::vector<scheme_entry>& schemes_;
  std::vector<run_length> runs_;
  int first_level_;
  std::vector<std::vector<growth>> found_;                             // [scheme][level]
  std::vector<std::vector<std::unique_ptr<tangent_kernel>>> kernels_;  // the same
  std::vector<sample_size> sizes_;
};

struct exponent {
  std::string name;
  Eigen::VectorXd growth::*values;
  std::optional<double> exact;  // empty: nothing to compare with
  double uncertainty;
};

void report_value(const exponent& e, const std::string& scheme, double dt, const interval_estimate& found,
                  report::results& out) {
  out.measurements.push_back(
      measured({"lyapunov", scheme, e.name, "", "per time", "sampled"}, dt, found.value, found.low, found.high));
}

void report_exponent(const exponent& e, const std::string& scheme, double dt, const interval_estimate& found,
                     double margin, report::results& out) {
  report_value(e, scheme, dt, found, out);
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

/// Of one scheme: |lambda_1 - exact| over dt, and the verdict on its order.
///
/// Half of the schemes err so little that an order takes some 10^8 path-steps: it is asked for at thorough effort
/// alone, whatever the samples of less are.
void report_order(const context& c, const sampled_levels& levels, std::size_t k, const scheme_entry& scheme,
                  double exact, double margin, report::results& out) {
  const auto dt = levels.dt();
  const int count = static_cast<int>(dt.size()), paths = levels.size(k).used;
  squared_errors errors{paths, count,
                        std::vector<double>(static_cast<std::size_t>(paths * count))};  // not squares here
  const series s{"lyapunov", std::string(scheme.info.name), "error of lambda_1", "", "per time", "sampled"};
  std::vector<report::measurement> points;
  double largest = 0;
  bool inside = true;
  for (int l = 0; l < count; ++l) {
    const auto values = levels.values(k, static_cast<std::size_t>(l), &growth::length, paths);
    for (int path = 0; path < paths; ++path) errors.at(path, l) = values[path] - exact;
    const auto m = level_mean(errors, l);
    const double error = std::fabs(m.mean), half = 1.96 * m.error;
    points.push_back(measured(s, dt[static_cast<std::size_t>(l)], error, std::max(0.0, error - half), error + half));
    inside = inside && error + half <= margin;  // not where it is not finite
    largest = std::max(largest, error + half);
  }
  const auto fit = fit_order_of_clear_means(dt, std::move(errors), clear, c.seed);
  record_fit(out, s, fit, std::move(points));
  const claim order{s.experiment, s.scheme, "order of the error of lambda_1"};
  const auto skip = [&](const std::string& reason) {
    out.skipped.push_back({order.experiment, order.scheme, order.text + ": " + reason});
  };
  if (c.effort != effort::thorough) return skip("asked for at thorough effort alone");
  if (!fit && inside)
    return skip(fmt::format("at every dt the error is at most {:.1e}, inside the margin of {:.1e}", largest, margin));
  out.verdicts.push_back(judge_order(order, weak_order_on(scheme.info, c.subject.model->noise()), fit, true));
  out.verdicts.back().reason += "; " + levels.size(k).text();
}

/// Those that have a stationary law on the sphere.
std::vector<scheme_entry> schemes_on_the_sphere(const subject& s, report::results& out) {
  std::vector<scheme_entry> kept;
  for (const auto& scheme : s.schemes) {
    if (scheme.info.casimir.exact)
      kept.push_back(scheme);
    else
      out.skipped.push_back(
          {"lyapunov", std::string(scheme.info.name),
           "leaves the sphere (experiment casimir): it has no stationary law there, hence no exponents"});
  }
  return kept;
}

/// Of each path until it is observed; empty, and why, if that is unknown or too long.
std::optional<double> time_to_forget(const context& c, double rate, report::results& out) {
  const auto p = *sphere_problem_of(c.subject);
  const auto gap = spectral_gap(p, 1e-3 * p.covariance.trace());
  std::string reason;
  const double time = relaxations / gap.value.value_or(0), steps = (1 + observed) * time * fine[0] * rate;
  if (!gap.converged())
    reason = "how long a start is remembered is not known: the spectral gap is " + gap.reason;
  else if (!(*gap.value > 0))
    reason = "the start is never forgotten: no stationary law is unique";
  else if (steps > by_effort(c.effort, 1e5, 2e5, 2e6))  // of a path; more is too dear to be offered
    reason = fmt::format("the start is remembered too long: {:.1e} steps a path", steps);
  if (reason.empty()) return time;
  out.skipped.push_back({"lyapunov", "", "sampled exponents: " + reason});
  return std::nullopt;
}

}  // namespace

void report_sampled_exponents(const context& c, const lyapunov_exponents& exact, report::results& out) {
  const auto schemes = schemes_on_the_sphere(c.subject, out);
  const double rate = fastest_rate(c.subject), margin = margin_share * rate;
  if (schemes.empty()) return;
  const auto forgotten = time_to_forget(c, rate, out);
  if (!forgotten) return;
  const auto runs = [&](std::span<const double> fineness, double times) {
    std::vector<run_length> all;
    for (const double n : fineness) all.push_back(run_length_of(1 / (n * rate), *forgotten, times * *forgotten));
    return all;
  };
  const double uncertainty = std::max(exact.uncertainty, exact.sum_uncertainty);
  const bool known = exact.lambda1 && uncertainty <= known_share * margin, resolved = known && exact.reason.empty();
  if (!resolved)
    out.skipped.push_back(
        {"lyapunov", "",
         fmt::format("{}: lambda_1 is {}",
                     known ? "order of the error of lambda_1" : "sampled exponents are compared with nothing",
                     exact.reason)});
  const auto if_known = [&](double x) { return known ? std::optional(x) : std::nullopt; };
  const exponent exponents[]{{"lambda_1", &growth::length, if_known(exact.lambda1.value_or(0)), exact.uncertainty},
                             {"lambda_1 + lambda_2", &growth::area, if_known(exact.sum), exact.sum_uncertainty}};

  const auto first = part_of(c, 0, 0.5), second = part_of(c, 0.5, 1);
  sampled_levels at_fine(first, schemes, runs(fine, observed), 0);
  at_fine.sample({256, by_effort(c.effort, 1024, 2048, 4096)}, tight_value * margin);
  const auto steps = std::span(coarse).first(by_effort<std::size_t>(c.effort, 5, 6, 6));
  sampled_levels levels(second, schemes, runs(steps, by_effort(c.effort, observed, observed, observed_thoroughly)), 1);
  if (resolved) levels.sample({512, by_effort(c.effort, 1024, 2048, 8192)}, tight_error * margin);
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    for (const auto& e : exponents)
      report_exponent(e, std::string(schemes[k].info.name), at_fine.dt()[0],
                      at_fine.mean(k, 0, e.values, at_fine.size(k).used), margin, out);
    note_sample_size(out, "lyapunov", schemes[k].info.name, at_fine.size(k));
    for (const auto& e : exponents)
      for (std::size_t l = 0; resolved && l < levels.dt().size(); ++l)
        report_value(e, std::string(schemes[k].info.name), levels.dt()[l],
                     levels.mean(k, l, e.values, levels.size(k).used), out);
    if (resolved) report_order(c, levels, k, schemes[k], *exact.lambda1, margin, out);
  }
}

}  // namespace polhode
