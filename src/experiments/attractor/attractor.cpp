// SPDX-License-Identifier: Apache-2.0
// What becomes of many bodies under one noise, and is it what the theory of random attractors says? (Crauel and
// Flandoli, Probab. Theory Relat. Fields 100 (1994) 365; Young, J. Stat. Phys. 108 (2002) 733.)
#include "experiments/attractor/attractor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/attractor/attractor_orbit.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/progress_counter.hpp"
#include "experiments/laws/true_law.hpp"
#include "sphere/spectral_gap.hpp"
#include "transfer/transfer.hpp"

namespace polhode {
namespace {

constexpr double exponent_accuracy = 1e-6, gap_accuracy = 1e-4;

std::optional<std::string> skip_reason(const subject& s) {
  if (!s.sphere()) return no_orbit_attractor(s);
  if (s.model->noise() == noise_class::none) return "no noise: the attractor is the set of equilibria";
  if (s.sphere()->is_spherical()) return "a spherical body turns rigidly: what is uniform stays so";
  if (dissipation_of(s.scene) == 0) return "no dissipation: area is kept, so what is uniform stays so";
  return std::nullopt;
}

/// Or why there is none.
struct framed {
  attractor_frame frame;
  std::string fault;
};

framed frame_of(const subject& s) {
  framed out{{*s.sphere(), true_law(s), {}, 0, 0.25 / fastest_rate(s), {}}, ""};
  auto& f = out.frame;
  if (!f.law.density || !f.law.reason.empty()) {
    out.fault = "the true stationary law is " + f.law.reason;
    return out;
  }
  const auto gap = spectral_gap(f.problem, gap_accuracy * fastest_rate(s));
  f.gap = gap.value.value_or(0);
  if (!gap.converged() || !(f.gap > 0)) {
    out.fault = "the rate at which a body forgets its start is " + gap.reason;
    return out;
  }
  f.exponents = lyapunov(f.problem, exponent_accuracy);
  for (const auto& e : s.schemes)
    if (e.info.casimir.exact) f.schemes.push_back(e);
  return out;
}

void report_shape(const context& c, const attractor_frame& f, noise_log& log, report::results& out) {
  const auto& lambda = f.exponents;
  if (!lambda.lambda1 || std::fabs(*lambda.lambda1) <= 3 * lambda.uncertainty)
    out.skipped.push_back({"attractor", "",
                           "rate of neighbours and dimensions: the sign of lambda_1 is not known" +
                               (lambda.reason.empty() ? "" : ", which is " + lambda.reason)});
  else {
    report_neighbours(part_of(c, 0, 0.6), f, log, out);
    if (*lambda.lambda1 > 0) report_dimensions(part_of(c, 0.6, 1), f, log, out);
  }
}

void run(const context& c, report::results& out) {
  if (!c.subject.sphere()) return report_orbit_attractor(c, out);
  for (const auto& scheme : c.subject.schemes)
    if (!scheme.info.casimir.exact)
      out.skipped.push_back({"attractor", std::string(scheme.info.name),
                             "leaves the sphere (experiment casimir), on which the random attractor lies"});
  const auto [frame, fault] = frame_of(c.subject);
  if (!fault.empty()) {
    out.skipped.push_back({"attractor", "", fault});
    return;
  }
  recorder("attractor", "", out).value({"dt of the averages", "", "time", "exact"}, frame.dt);
  noise_log log(*c.subject.model, 0, {});
  report_averages(part_of(c, 0, 0.5), frame, log, out);
  report_pullback(part_of(c, 0.5, 0.65), frame, log, out);
  report_shape(part_of(c, 0.65, 0.95), frame, log, out);
  report_densities(part_of(c, 0.95, 1), frame, log, out);
  log.report("attractor", out);
}

expected_work work_of(const subject& s, effort e) {
  if (s.sphere()) return {by_effort(e, 7e7, 9e8, 9e9), 0};
  return {by_effort(e, 5e6, 2e7, 2e8), 0};
}

}  // namespace

std::int64_t attractor_frame::steps_in(double time, double step) const {
  return std::max<std::int64_t>(1, std::llround(time / step));
}

noise_source fast_noise(const context& c) { return {c.generator, noise_quality::fast}; }

simulation_plan common_noise_plan(const context& c) {
  simulation_plan p;
  p.noise = ensemble_noise::common;
  p.start = ensemble_start::uniform;
  p.momentum = c.subject.scene.momentum;
  p.source = fast_noise(c);
  p.seed = c.seed;
  p.threads = c.threads;
  return p;
}

double affordable(effort e, double path_steps_at_quick) { return path_steps_at_quick * by_effort(e, 1, 10, 100); }

experiment attractor_experiment() {
  return {
      {"attractor",
       "What becomes of bodies all over their orbit under one common noise?",
       {"On a sphere. Averages: per noise path the harmonics (to degree 2) of the random measure of 8 bodies from a "
        "uniform start, "
        "after one body has forgotten it to 1e-3, and eleven more times, each a third of that later. Over N paths the "
        "square of the mean's distance from the true law is "
        "b^2 + V/N, b the exact bias of the scheme's own law (transfer operator): with b^2 taken off the slope must be "
        "-1/2, and the mean over all paths must be the scheme's own law to a tenth of a standard deviation of any "
        "function.",
        "Pullback: bodies start uniformly at -T with the same noise up to time 0. Change: from one T to the next, "
        "root-mean-square over noise paths and, of each, over seven times 0 (fewer where a span takes many steps), by "
        "two "
        "independent sets of bodies, so that their number leaves no bias.",
        "The rate at which bodies 1e-6 apart meet or part (set back to that distance now and then), over many noise "
        "paths, against the exact lambda_1.",
        "Where lambda_1 > 0, to look at: numbers of boxes of equal area that are occupied, that hold the information, "
        "that hold the pairs, against their side; mean slopes over noise paths of the Wong-Zakai equation. D_2 <= D_1 "
        "<= D_0. Finite samples miss boxes, the more the smaller: D_0 comes out too low, D_1 slightly (first order "
        "corrected), D_2 not. No claim: D_1 tends to Kaplan and Yorke's as boxes get small against the size at which "
        "the growth of "
        "lengths has outrun its own fluctuations, and bodies that can be followed do not fill boxes so small. Before "
        "that it is too high while the uniform start shrinks to the attractor, and too low afterwards.",
        "Elsewhere, on a coadjoint orbit: bodies start at random coadjoint images of the scene's momentum (uniform on "
        "a "
        "product of spheres). Neighbours 1e-6 apart, set back to that every eight steps, must meet or part at the rate "
        "lambda_1 of the equation, sampled as in the experiment lyapunov, on the same paths; bodies must stay on the "
        "orbit. Pictures: the direction of a vector of constant length, as of the vertical of a top or of the first "
        "spin, at half, one, two and four times that in which the volume of a set shrinks by e.",
        "Normals: fast ones. Areas from the weak surrogate, as in the transfer operator. Noise: the moments and "
        "correlations of all paths drawn, part by part, against their law; of one scheme, as all have the same."}},
      work_of,
      skip_reason,
      run};
}

}  // namespace polhode
