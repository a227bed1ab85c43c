// SPDX-License-Identifier: Apache-2.0
// Ephrati, Jansson, Lang and Luesink prove orders of an implicit midpoint rule for stochastic Lie-Poisson systems.
#include <algorithm>
#include <stdexcept>

#include "reproduction/cases.hpp"
#include "reproduction/judged.hpp"
#include "reproduction/scenes.hpp"
#include "run/verify.hpp"

namespace polhode {
namespace {

constexpr double order_margin = 0.1;

/// The estimate of a claim, with its interval.
interval_estimate estimate_of(const report::results& r, std::string_view experiment, std::string_view claim) {
  const auto found = std::ranges::find_if(
      r.verdicts, [&](const report::verdict& v) { return v.experiment == experiment && v.claim == claim; });
  if (found == r.verdicts.end() || !found->estimate || !found->low || !found->high)
    throw std::logic_error("no estimate of " + std::string(claim));
  return {*found->estimate, *found->low, *found->high};
}

}  // namespace

report::reproduction lie_poisson_midpoint(const reproduce_options& o) {
  report::reproduction out;
  out.source =
      "Ephrati, Jansson, Lang, Luesink, An exponential map free implicit midpoint method for stochastic Lie-Poisson "
      "systems, arXiv:2408.16701: Casimirs kept almost surely, root-mean-square order 1/2, weak order 1";
  out.scene =
      "name = \"lie_poisson_midpoint\"\nsystem = \"rigid_body\"\ninertia = [1.0, 2.0, 3.0]\ntheta = 0.0\nsigma = "
      "0.5\nmomentum = [0.6, 0.48, 0.64]\nhorizon = 2.0\nsteps = [4, 8, 16, 32, 64]\n";
  out.notes = {
      "By the abstract: the parameters of their numerical examples were not at hand, so the body is one of ours."};
  verify_options options;
  options.schemes = {"isospectral_midpoint"};
  options.experiments = {"casimir", "strong", "weak"};
  options.effort = o.effort == effort::thorough ? effort::standard : effort::quick;
  options.threads = o.threads;
  options.seed = o.seed;
  const auto found = verify(scene_of(out.scene), options);
  out.numbers = {compared_at_most("Casimir: largest relative change over a long run", 1e-12,
                                  estimate_of(found, "casimir", "Casimirs kept to rounding"),
                                  "theirs is kept almost surely; the bound is rounding of a long run"),
                 compared("root-mean-square order on the rigid body, noise that does not commute", 0.5, order_margin,
                          estimate_of(found, "strong", "strong order"),
                          "tolerance: 0.1, as for every order here; by experiment strong"),
                 compared("weak order on the rigid body: the slowest observable", 1, order_margin,
                          estimate_of(found, "weak", "weak order"),
                          "tolerance: 0.1, as for every order here; by experiment weak, nothing sampled")};
  return out;
}

}  // namespace polhode
