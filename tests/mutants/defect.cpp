// SPDX-License-Identifier: Apache-2.0
#include "mutants/defect.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "mutants/defective_kernel.hpp"
#include "mutants/in_step.hpp"
#include "mutants/in_tuning.hpp"
#include "run/run_experiment.hpp"
#include "run/verify.hpp"

namespace polhode::test {
namespace {

/// How a kind is written: the pattern takes its size, or its factor 1 + size.
struct kind_text {
  test::kind kind;
  const char *name, *pattern;
  bool factor = false;
};
constexpr kind_text texts[] = {
    {kind::none, "none", "healthy"},
    {kind::noise, "noise", "sigma x {:g}", true},
    {kind::theta, "dissipation", "theta x {:g}", true},
    {kind::inertia_1, "inertia", "I_1 x {:g}", true},
    {kind::inertia_2, "inertia", "I_2 x {:g}", true},
    {kind::inertia_3, "inertia", "I_3 x {:g}", true},
    {kind::channel_1, "one noise vector", "sigma_1 x {:g}", true},
    {kind::sub_flow, "dt of the sub-flows", "dt of the flows x {:g}", true},
    {kind::horizon, "horizon", "horizon x {:g}", true},
    {kind::step_count, "number of steps", "{:+g} steps"},
    {kind::last_steps, "last steps not taken", "last {:g} of several steps not taken"},
    {kind::dw, "increments", "dW x {:g}", true},
    {kind::area, "areas", "areas x {:g}", true},
    {kind::area_mixed, "areas", "areas redrawn at every level"},
    {kind::channels, "channels correlated", "correlation {:g} of channels 1 and 2"},
    {kind::lanes, "paths repeated", "{:g} paths of 64 repeat others"},
    {kind::neighbours, "paths interchanged", "noise of the path {:g} places on"},
    {kind::steps, "increments reused", "every second increment is the one before"},
    {kind::clip, "increments clipped", "dW_i cut at {:g} sqrt(dt)"},
    {kind::branch, "rare branch", "no noise beyond {:g} sqrt(dt)"},
    {kind::float_state, "state in float", "state rounded to float"},
    {kind::float_projected, "state in float, projected", "state rounded to float, projected"},
    {kind::turn, "projected but wrong", "turned by {:g} dt, projected"},
    {kind::shrink, "shrinking", "state x (1 - {:g} dt)"},
    {kind::ito_drift, "Ito drift", "Ito drift x {:+g} added"},
    {kind::unfinished, "look not finished", "half a turn missing in a look between pieces"},
    {kind::reopened, "pieces opened anew", "half a turn missing between pieces"},
    {kind::transposed, "common noise transposed", "matrices of the common noise transposed"},
    {kind::weights, "weights of the stages", "weights 1/2 +- {:g}"},
    {kind::half_missing, "1/2 missing", "1/2 of the stages' sum x {:g}", true},
    {kind::stage, "stage misplaced", "second stage {:g} short"},
    {kind::halves, "halves not mirrored", "halves of (1 +- {:g}) dt/2"},
    {kind::exponential, "exponential cut", "exponential cut after two terms"},
    {kind::flip, "rare sign", "state flipped beyond {:g} sqrt(dt)"},
    {kind::dissipation_sign, "dissipation sign", "dissipation sign as the paper prints it"},
    {kind::half_turn, "half turn", "half turn x {:g}", true},
    {kind::half_shear, "half turn, as a shear", "half shear x {:g}", true},
    {kind::casimir_shift, "Casimir shift", "Casimir shift by the axis {:g}"},
    {kind::damping_halved, "damping of half a step", "damping of half a step for a whole"},
    {kind::normalisation, "normalisation", "normalising polynomial a degree short"},
    {kind::reach, "reach of polynomials", "polynomials beyond their reach"},
    {kind::generator_dw, "generator: increments", "generator: dW x {:g}", true},
    {kind::generator_channels, "generator: channels correlated", "generator: correlation {:g} of channels 1 and 2"},
    {kind::generator_lanes, "generator: paths repeated", "generator: {:g} paths of 64 repeat others"},
    {kind::generator_steps, "generator: increments reused", "generator: every second increment is the one before"},
    {kind::generator_clip, "generator: clipped", "generator: dW_i cut at {:g} sqrt(dt)"},
    {kind::generator_paths, "generator: blocks repeated", "generator: paths begin again after {:g} blocks"},
    {kind::generator_area, "generator: areas", "generator: areas x {:g}", true},
    {kind::strong_claim, "over-claim: strong order", "strong order + {:g} claimed"},
    {kind::weak_claim, "over-claim: weak order", "weak order + {:g} claimed"},
    {kind::path_claim, "over-claim: deterministic order", "deterministic order + {:g} claimed"},
    {kind::drift_claim, "over-claim: Casimir drift", "order of the Casimir drift + {:g} claimed"},
    {kind::casimir_claim, "over-claim: Casimirs kept", "exact Casimirs claimed"},
    {kind::poisson_claim, "over-claim: Poisson map", "a Poisson map claimed"},
};

const kind_text& text_of(kind k) { return *std::ranges::find(texts, k, &kind_text::kind); }

bool is_of_scene(kind k) { return k >= kind::noise && k <= kind::channel_1; }
bool is_of_kernel(kind k) { return k >= kind::sub_flow && k <= kind::transposed; }
bool is_of_step(kind k) { return k >= kind::weights && k <= kind::flip; }
bool is_of_tuning(kind k) { return k >= kind::dissipation_sign && k <= kind::reach; }

report::scene changed(report::scene s, const defect& d) {
  const auto vectors = d.kind == kind::noise ? s.vectors("sigma").size() : d.kind == kind::channel_1 ? 1 : 0;
  for (std::size_t i = 0; i < std::min(vectors, s.vectors("sigma").size()); ++i)
    for (double& x : s.vectors("sigma")[i]) x *= 1 + d.size;
  if (d.kind == kind::theta) s.number("theta") *= 1 + d.size;
  if (d.kind >= kind::inertia_1 && d.kind <= kind::inertia_3)
    s.vector("inertia")[static_cast<std::size_t>(d.kind) - static_cast<std::size_t>(kind::inertia_1)] *= 1 + d.size;
  return s;
}

void claim_more(scheme_info& info, const defect& d) {
  switch (d.kind) {
    case kind::strong_claim:
      info.strong_order.commuting += d.size;
      info.strong_order.general += d.size;
      return;
    case kind::weak_claim:
      info.weak_order.one_vector += d.size;
      info.weak_order.isotropic += d.size;
      info.weak_order.general += d.size;
      return;
    case kind::path_claim: info.deterministic_order += static_cast<int>(d.size); return;
    case kind::drift_claim: info.casimir.noisy_order += d.size; return;
    case kind::casimir_claim: info.casimir = keeps_casimirs; return;
    case kind::poisson_claim: info.poisson = true; return;
    default: return;
  }
}

subject bound_to(const report::scene& scene, std::string_view scheme) {
  auto s = restricted(bind_scene(scene), {std::string(scheme)});
  if (s.schemes.size() != 1) throw std::invalid_argument(fmt::format("no scheme {}", scheme));
  return s;
}

}  // namespace

std::string_view name_of(kind k) { return text_of(k).name; }

std::string described(const defect& d) {
  const auto& t = text_of(d.kind);
  return fmt::format(fmt::runtime(t.pattern), t.factor ? 1 + d.size : d.size);
}

subject planted(const report::scene& scene, std::string_view scheme, const defect& d) {
  auto s = bound_to(scene, scheme);
  auto& entry = s.schemes.front();
  if (is_of_scene(d.kind)) entry = bound_to(changed(scene, d), scheme).schemes.front();
  if (is_of_kernel(d.kind))
    entry.make = [healthy = entry, scene, d](double dt) { return defective(healthy, scene, d, dt); };
  const auto with = [&](auto defective_kernel) {
    entry.make = [=, name = std::string(scheme)](double dt) { return defective_kernel(scene, name, d, dt); };
  };
  if (is_of_step(d.kind)) with(defective_step);
  if (is_of_tuning(d.kind)) with(defective_tuning);
  claim_more(entry.info, d);
  s.with = [name = std::string(scheme), d](const report::scene& other) { return planted(other, name, d); };
  return s;
}

}  // namespace polhode::test
