// Does a long run visit the sphere as the Gibbs law exp(-2 theta h / sigma^2) says?
//
// Twice: sampled at one small dt, and exactly over dt (stationary_bias.hpp). Sampled: independent paths start uniformly
// on the sphere, forget their start, and are then observed at several times. The mean over the times of one path is one
// sample, so the interval over paths knows the autocorrelation without estimating it.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "ensemble/paths.hpp"
#include "ensemble/uniform_start.hpp"
#include "experiments/experiment.hpp"
#include "experiments/judge.hpp"
#include "experiments/levels.hpp"
#include "experiments/noise_verdict.hpp"
#include "experiments/progress_counter.hpp"
#include "experiments/sequential.hpp"
#include "experiments/stationary_bias.hpp"
#include "experiments/undecided.hpp"
#include "experiments/vectors.hpp"
#include "references/gibbs.hpp"
#include "statistics/sample.hpp"

namespace polhode {
namespace {

constexpr double moment_margin = 0.1;        // of the standard deviation of the observable: how far a mean may lie
constexpr double uniform_deviation = 0.298;  // of Pi_k^2 / c^2 on the uniform sphere: sqrt(4/45)
constexpr double ks_bound = 0.05;            // Kolmogorov-Smirnov distance allowed
constexpr int observations = 4;
constexpr double tight_share = 1.0 / 3;  // of a margin: the half-width at which sampling stops
constexpr double most_steps = 10'000;    // of a path, before sampling is too dear to be offered

/// The least eigenvalue of sum sigma_i sigma_i^T: sigma^2 where the noise is isotropic, else its weakest direction.
double noise_strength(const report::scene& s) {
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& v : s.sigma) {
    const Eigen::Map<const Eigen::Vector3d> e(v.data());
    covariance += e * e.transpose();
  }
  return std::max(0.0, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues()[0]);
}

/// Time to forget the start: relaxation on the sphere (rate sigma^2), slowed by the barrier between the wells of h.
/// Damping and rotation only help; the factor five is a choice.
double burn_in(const report::scene& s) {
  auto inertia = s.inertia;
  std::ranges::sort(inertia);
  const double c = length(s.momentum), sigma2 = noise_strength(s);
  const double barrier = 0.5 * c * c * (1 / inertia[1] - 1 / inertia[2]);
  return 5 / sigma2 * std::exp(2 * s.theta / sigma2 * barrier);
}

double step_size(const subject& s) { return 0.04 / fastest_rate(s); }

struct design {
  double dt, burn, spacing;
};

design plan(const context& c) {
  const auto& s = c.subject.scene;
  return {step_size(c.subject), burn_in(s), 1 / noise_strength(s)};
}

/// What is kept of every path: means over its observations, and the last energy.
struct observed {
  std::vector<double> energy, square1, square3, energy2, last_energy;
  explicit observed(std::size_t paths)
      : energy(paths), square1(paths), square3(paths), energy2(paths), last_energy(paths) {}
};

void observe(const model& m, std::span<const double> states, int block, observed& out) {
  for (int lane = 0; lane < block_lanes; ++lane) {
    const auto mu = lane_of(states, lane, m.dimension());
    const auto path = static_cast<std::size_t>(block * block_lanes + lane);
    const double h = m.energy(mu);
    out.energy[path] += h / observations;
    out.energy2[path] += h * h / observations;
    out.square1[path] += mu[0] * mu[0] / observations;
    out.square3[path] += mu[2] * mu[2] / observations;
    out.last_energy[path] = h;
  }
}

/// Runs one block of paths of the open schemes through the same noise.
void run_block(const context& c, const design& d, std::span<const scheme_entry> schemes,
               std::span<const std::unique_ptr<kernel>> kernels, std::span<const int> open, int block,
               std::vector<observed>& out, noise_log& log) {
  constexpr int chunk = 200;
  const auto& s = c.subject;
  const std::vector<std::size_t> indices(open.begin(), open.end());
  const bool areas = std::ranges::any_of(indices, [&](std::size_t k) { return schemes[k].needs_areas; });
  increment_buffer noise(*s.model, chunk, areas, {c.generator, noise_quality::fast});
  const auto first_path = static_cast<std::uint64_t>(block * block_lanes);
  std::vector<std::vector<double>> states(kernels.size(), uniform_states(c.seed, first_path, length(s.scene.momentum)));
  std::uint64_t step = 0;
  const auto advance = [&](double time) {
    for (int left = std::max(1, static_cast<int>(time / d.dt)); left > 0;) {
      const int n = std::min(left, chunk);
      const auto view = noise.fill(c.seed, first_path, step, n, d.dt);
      log.add(block, view);
      for (const auto k : indices) kernels[k]->advance(states[k], view);
      step += static_cast<std::uint64_t>(n);
      left -= n;
    }
  };
  advance(d.burn);
  for (int i = 0; i < observations; ++i) {
    advance(d.spacing);
    for (const auto k : indices) observe(*s.model, states[k], block, out[k]);
  }
}

/// The mean of one observable: what it is compared with.
struct moment {
  std::string observable;
  std::vector<double> observed::*values;
  double exact, margin;
};

std::vector<moment> moments_of(const gibbs_law& law, double radius) {
  const double deviation = std::sqrt(law.energy_variance()), mean = law.mean_energy();
  const double square = uniform_deviation * radius * radius;
  return {{"energy", &observed::energy, mean, moment_margin * deviation},
          {"energy^2", &observed::energy2, law.energy_variance() + mean * mean, moment_margin * 2 * mean * deviation},
          {"pi1^2", &observed::square1, law.mean_square(0), moment_margin * square},
          {"pi3^2", &observed::square3, law.mean_square(2), moment_margin * square}};
}

/// What is found for one scheme at the end of a batch.
struct finding {
  std::vector<interval_estimate> means;
  interval_estimate ks;
};

finding find(const gibbs_law& law, const std::vector<moment>& moments, const observed& o, int paths) {
  const auto first = [&](const std::vector<double>& v) { return std::span(v).first(static_cast<std::size_t>(paths)); };
  finding f;
  for (const auto& m : moments) f.means.push_back(mean_interval(first(o.*m.values)));
  f.ks = ks_distance(first(o.last_energy), [&](double h) { return law.energy_cdf(h); });
  return f;
}

/// By widths alone. (The Kolmogorov-Smirnov interval reaches as far above its distance whatever that is.)
bool tight(const std::vector<moment>& moments, const finding& f) {
  for (std::size_t i = 0; i < moments.size(); ++i)
    if (half_width(f.means[i]) > tight_share * moments[i].margin) return false;
  return f.ks.high - f.ks.value <= tight_share * ks_bound;
}

void report_moment(const std::string& scheme, const moment& what, double dt, const interval_estimate& m,
                   report::results& out) {
  out.measurements.push_back(
      measured({"gibbs", scheme, "mean", what.observable, "", "sampled"}, dt, m.value, m.low, m.high));
  report::verdict v{"gibbs", scheme, "mean of " + what.observable,       what.exact, {},
                    {},      {},     report::verdict_kind::inconclusive, ""};
  if (!std::isfinite(m.value)) {
    v.reason = "paths were lost: not finite";
  } else {
    v.estimate = m.value;
    v.low = m.low;
    v.high = m.high;
    v.kind = judge(what.exact, m.low, m.high, what.margin);
    v.reason = fmt::format("[{:.6f}, {:.6f}] against {:.6f} +- {:.2g} (a tenth of a standard deviation)", m.low, m.high,
                           what.exact, what.margin);
  }
  out.verdicts.push_back(v);
}

void report_scheme(const std::vector<moment>& moments, const std::string& scheme, double dt, const finding& f,
                   report::results& out) {
  for (std::size_t i = 0; i < moments.size(); ++i) report_moment(scheme, moments[i], dt, f.means[i], out);
  out.measurements.push_back(
      measured({"gibbs", scheme, "ks_distance", "energy", "", "sampled"}, dt, f.ks.value, f.ks.low, f.ks.high));
  out.verdicts.push_back(
      judge_distance({"gibbs", scheme, "law of the energy"}, f.ks, ks_bound,
                     fmt::format("Kolmogorov-Smirnov distance {:.4f} in [{:.4f}, {:.4f}], bound {:g}", f.ks.value,
                                 f.ks.low, f.ks.high, ks_bound)));
}

void report_samples(const context& c, report::results& out) {
  const auto& s = c.subject;
  const double radius = length(s.scene.momentum);
  const gibbs_law law(s.scene.inertia, radius, 2 * s.scene.theta / noise_strength(s.scene));
  const auto d = plan(c);
  std::vector<scheme_entry> schemes;
  std::ranges::copy_if(s.schemes, std::back_inserter(schemes), [](const auto& e) { return e.info.casimir.exact; });
  std::vector<std::unique_ptr<kernel>> kernels;
  for (const auto& scheme : schemes) kernels.push_back(scheme.make(d.dt));
  const sampling_plan paths{2048, by_effort(c.effort, 4096, 16'384, 32'768)};
  std::vector<observed> samples(kernels.size(),
                                observed(static_cast<std::size_t>(blocks_of(paths.most) * block_lanes)));
  const auto moments = moments_of(law, radius);
  noise_log log(*s.model, blocks_of(paths.most));
  std::vector<finding> found(kernels.size());
  const auto sizes = sample_until_tight(
      c, paths, static_cast<int>(kernels.size()),
      [&](int block, std::span<const int> open) { run_block(c, d, schemes, kernels, open, block, samples, log); },
      [&](int scheme, int so_far) {
        const auto k = static_cast<std::size_t>(scheme);
        found[k] = find(law, moments, samples[k], so_far);
        return tight(moments, found[k]);
      });
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    const std::string name(schemes[k].info.name);
    report_scheme(moments, name, d.dt, found[k], out);
    note_sample_size(out, "gibbs", name, sizes[k]);
  }
  log.report("gibbs", out);
}

std::optional<std::string> cannot_say(const subject& s) {
  const auto& i = s.scene.inertia;
  if (s.model->noise() == noise_class::none)
    return "no noise: the law concentrates on the axis of least energy (experiment energy)";
  if (i[0] == i[1] && i[1] == i[2]) return "equal moments of inertia: h is constant on the sphere";
  return std::nullopt;
}

/// Why no law is claimed that could be sampled; empty: one is.
std::optional<std::string> no_law(const subject& s) {
  if (s.model->noise() != noise_class::isotropic && s.scene.theta > 0)
    return "the noise is not isotropic: no Gibbs law is claimed for it";
  if (noise_strength(s.scene) <= 1e-12 * fastest_rate(s)) return "the noise does not reach every direction by itself";
  return std::nullopt;
}

void sample(const context& c, report::results& out) {
  if (const auto reason = no_law(c.subject)) {
    out.skipped.push_back({"gibbs", "", "sampled law: " + *reason});
    return;
  }
  std::vector<scheme_entry> schemes;
  std::ranges::copy_if(c.subject.schemes, std::back_inserter(schemes),
                       [](const scheme_entry& e) { return e.info.casimir.exact; });
  const dear_claim law{"gibbs",
                       "mean of energy",
                       "the wells of h are deep: forgetting the start",
                       "steps a path",
                       burn_in(c.subject.scene) / step_size(c.subject),
                       [](effort) { return most_steps; }};
  if (affords(c, schemes, law, out)) report_samples(c, out);
}

void run(const context& c, report::results& out) {
  for (const auto& scheme : c.subject.schemes)
    if (!scheme.info.casimir.exact)
      out.skipped.push_back(
          {"gibbs", std::string(scheme.info.name),
           "leaves the sphere (experiment casimir), so it has no stationary law there and claims none"});
  sample(part_of(c, 0, 0.5), out);
  report_stationary_bias(part_of(c, 0.5, 1), out);
}

}  // namespace

experiment gibbs_experiment() {
  return {
      {"gibbs",
       "Does a long run visit the sphere as the Gibbs law exp(-2 theta h / sigma^2) says?",
       {"Independent paths from a uniform start; means over four times of each path after it has forgotten its "
        "start, so "
        "that the interval over paths accounts for autocorrelation.",
        fmt::format(
            "Exact law of h: complete elliptic integrals. A mean holds if its 95 % interval lies within {:g} "
            "standard deviations of the exact one; the law of h if the Kolmogorov-Smirnov distance is below {:g} "
            "with 95 % confidence (Dvoretzky-Kiefer-Wolfowitz).",
            moment_margin, ks_bound),
        "Without dissipation the law is uniform for any noise that reaches every direction.",
        "Bias of the mean of every observable and distance of the densities (L2) over dt: the law that the scheme's "
        "transfer operator leaves as it is, nothing sampled (experiment weak). True law: the Gibbs density, or for "
        "other noise the null vector of the Kolmogorov operator. Where neither is resolved: the difference of the two "
        "laws on harmonics of one degree, without distance, uncertain by the remainders of both Poisson equations "
        "against both laws, in absolute values degree by degree (Becker and Rannacher 2001): at least what four "
        "degrees more change. Judged like the weak errors; the slowest decides on the order, and the limit at dt = 0 "
        "is asked of all means. Means that vanish by symmetry have no slope.",
        "Normals: fast ones (right to 1e-6). Areas are drawn from the weak surrogate (independent normals of variance "
        "dt^2/4)."}},
      4,
      cannot_say,
      run};
}

}  // namespace polhode
