// SPDX-License-Identifier: Apache-2.0
// Does a long run visit its orbit as the Gibbs law exp(-2 theta h / sigma^2) says?
//
// On a sphere twice: sampled at one small dt (gibbs_sampled.hpp), and exactly over dt (stationary_bias.hpp). Elsewhere
// sampled against the means that a system knows (gibbs_on_orbits.hpp).
#include <fmt/format.h>

#include "experiments/common/experiment.hpp"
#include "experiments/common/operator_work.hpp"
#include "experiments/common/progress_counter.hpp"
#include "experiments/gibbs/gibbs_moments.hpp"
#include "experiments/gibbs/gibbs_on_orbits.hpp"
#include "experiments/gibbs/gibbs_sampled.hpp"
#include "experiments/gibbs/long_runs.hpp"
#include "experiments/laws/stationary_bias.hpp"

namespace polhode {
namespace {

std::optional<std::string> skip_reason(const subject& s) {
  if (s.model->noise() == noise_class::none)
    return "no noise: the law concentrates on the axis of least energy (experiment energy)";
  if (s.sphere() && s.sphere()->is_spherical()) return "h is constant on the sphere";
  return std::nullopt;
}

void run(const context& c, report::results& out) {
  if (!c.subject.sphere()) report_stationary_bias(c, out);  // says why there is none
  for (const auto& scheme : c.subject.schemes)
    if (!scheme.info.casimir.exact)
      out.skipped.push_back(
          {"gibbs", std::string(scheme.info.name),
           fmt::format("leaves the {} (experiment casimir), so it has no stationary law there and claims none",
                       c.subject.sphere() ? "sphere" : "orbit")});
  if (!c.subject.sphere()) return report_sampled_means(c, out);
  report_sampled_law(part_of(c, 0, 0.5), out);
  report_stationary_bias(part_of(c, 0.5, 1), out);
}

expected_work work_of(const subject& s, effort e) {
  if (s.sphere()) return {by_effort(e, 6e6, 1.5e7, 3e7), by_sphere(s, 0.1, 2, 0.2)};
  if (no_gibbs_means(s)) return {};
  return {by_effort(e, 9e6, 3e7, 1e8), 0};
}

}  // namespace

experiment gibbs_experiment() {
  return {
      {"gibbs",
       "Does a long run visit its orbit as the Gibbs law exp(-2 theta h / sigma^2) says?",
       {"On a sphere: independent paths from a uniform start; means over four times of each path after it has "
        "forgotten its start, so that the interval over paths accounts for autocorrelation.",
        fmt::format(
            "Exact law of h: complete elliptic integrals. A mean holds if its 95 % interval lies within {:g} standard "
            "deviations of the exact one; the law of h if the Kolmogorov-Smirnov distance is below {:g} with 95 % "
            "confidence (Dvoretzky-Kiefer-Wolfowitz).",
            moment_margin, ks_bound),
        fmt::format(
            "On other systems: paths half from the scene's momentum and half from all over the orbit. A pilot run of "
            "the driven equation tells the longest integrated autocorrelation time of the energy, the components (the "
            "first {}) and their squares, and that both kinds of start have the same means. After ten of these times "
            "a path is averaged over twenty; the interval is over paths. Exact means are those that the system knows "
            "of its Gibbs law, and the margin is the same, by the standard deviation in the pilot run. The law of h "
            "as a whole, or of a component, is compared where it is known in closed form, by ten values of each path: "
            "two of the same times apart, and worth three quarters as many independent ones.",
            averaged_components),
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
      work_of,
      skip_reason,
      run};
}

}  // namespace polhode
