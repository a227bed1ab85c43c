#include "experiments/lyapunov_sampled.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "experiments/judge.hpp"
#include "experiments/levels.hpp"
#include "experiments/sequential.hpp"
#include "experiments/tangent_runs.hpp"
#include "experiments/transfer.hpp"
#include "experiments/transfer_report.hpp"
#include "statistics/control_variates.hpp"
#include "statistics/order_fit.hpp"

namespace polhode {
namespace {

constexpr std::array fine{32.0};                  // steps per fastest time scale where exponents are compared
constexpr std::array coarse{1.0, 2.0, 4.0, 8.0};  // where the order is looked for
constexpr double margin_share = 1e-3;             // of the fastest rate: how far an exponent may lie
constexpr double tight_value = 1.0 / 5;           // of the margin: the half-width at which sampling stops
constexpr double tight_error = 1.0 / 20;          // the same where errors are to be resolved
constexpr double clear = 5;                       // standard errors
constexpr double relaxations = 8;                 // until the start is forgotten, to e^-8
constexpr double observed = 20;                   // times as long as that
constexpr double most_steps = 1e6;                // of a path, before sampling is too dear to be offered

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
  interval_estimate raw(std::size_t scheme, std::size_t level, Eigen::VectorXd growth::*what, int paths) const {
    const auto& all = found_[scheme][level].*what;
    return mean_interval({all.data(), static_cast<std::size_t>(paths)});
  }

 private:
  void run(int block, std::span<const int> open) {
    for (std::size_t l = 0; l < runs_.size(); ++l) {
      std::vector<const tangent_kernel*> kernels;
      std::vector<growth*> out;
      for (const int k : open) {
        kernels.push_back(kernels_[static_cast<std::size_t>(k)][l].get());
        out.push_back(&found_[static_cast<std::size_t>(k)][l]);
      }
      run_tangents(context_, runs_[l], first_level_ + static_cast<int>(l), block, kernels, any_needs_areas(schemes_),
                   out);
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
  double exact, uncertainty;
};

void report_exponent(const exponent& e, const std::string& scheme, double dt, const interval_estimate& found,
                     double margin, report::results& out) {
  out.measurements.push_back(
      measured({"lyapunov", scheme, e.name, "", "per time", "sampled"}, dt, found.value, found.low, found.high));
  report::verdict v{"lyapunov", scheme, "finds " + e.name, e.exact, {}, {}, {}, report::verdict_kind::inconclusive, ""};
  if (!std::isfinite(found.value)) {
    v.reason = "not finite: a step of the scheme fails";
  } else {
    v.estimate = found.value;
    v.low = found.low;
    v.high = found.high;
    v.kind = judge(e.exact, found.low, found.high, margin - e.uncertainty);
    v.reason = fmt::format("[{:.6f}, {:.6f}] at dt = {:.3g} against {:.6f} +- {:.2g}", found.low, found.high, dt,
                           e.exact, margin);
  }
  out.verdicts.push_back(v);
}

}  // namespace

void report_sampled_exponents(const context& c, const lyapunov_exponents& exact, report::results& out) {
  std::vector<scheme_entry> schemes;
  for (const auto& scheme : c.subject.schemes)
    if (scheme.info.casimir.exact)
      schemes.push_back(scheme);
    else
      out.skipped.push_back({"lyapunov", std::string(scheme.info.name),
                             "leaves the sphere (experiment casimir): it has no stationary law there, hence no "
                             "exponents"});
  const double rate = fastest_rate(c.subject), margin = margin_share * rate;
  const auto p = *sphere_problem_of(c.subject);
  const auto gap = spectral_gap(p, 1e-3 * p.covariance.trace());
  const double forgotten = relaxations / *gap.value;
  fmt::print("gap {} rate {} margin {}\n", *gap.value, rate, margin);
  const auto runs = [&](std::span<const double> fineness) {
    std::vector<run_length> all;
    for (const double n : fineness) all.push_back(run_length_of(1 / (n * rate), forgotten, observed * forgotten));
    return all;
  };
  const std::vector<exponent> exponents{{"lambda_1", &growth::length, exact.lambda1.value_or(NAN), exact.uncertainty},
                                        {"lambda_1 + lambda_2", &growth::area, exact.sum, exact.sum_uncertainty}};
  const auto now = [] { return double(clock()) / CLOCKS_PER_SEC; };
  double t0 = now();
  const char* env = getenv("CO");
  sampled_levels at_fine(c, schemes, runs(fine), 0);
  at_fine.sample({256, 1024}, tight_value * margin);
  fmt::print("fine {:.2f}s\n", now() - t0), t0 = now();
  for (std::size_t k = 0; k < schemes.size(); ++k)
    for (const auto& e : exponents) {
      report_exponent(e, std::string(schemes[k].info.name), at_fine.dt()[0],
                      at_fine.mean(k, 0, e.values, at_fine.size(k).used), margin, out);
      fmt::print("{} used {} raw half {} controlled {}\n", out.verdicts.back().scheme + out.verdicts.back().reason,
                 at_fine.size(k).used, half_width(at_fine.raw(k, 0, e.values, at_fine.size(k).used)),
                 half_width(at_fine.mean(k, 0, e.values, at_fine.size(k).used)));
    }
  sampled_levels levels(c, schemes, runs(coarse), 1);
  levels.sample({512, env ? atoi(env) : 1024}, tight_error * margin);
  fmt::print("coarse {:.2f}s\n", now() - t0), t0 = now();
  for (std::size_t k = 0; k < schemes.size(); ++k)
    for (const auto& e : exponents)
      for (std::size_t l = 0; l < coarse.size(); ++l) {
        const auto m = levels.mean(k, l, e.values, levels.size(k).used);
        const auto r = levels.raw(k, l, e.values, levels.size(k).used);
        fmt::print("{:18} {:20} dt {:.4f} err {:+.6f} +- {:.6f} raw +- {:.6f} used {}\n", schemes[k].info.name, e.name,
                   levels.dt()[l], m.value - e.exact, half_width(m), half_width(r), levels.size(k).used);
      }
}

}  // namespace polhode
