// SPDX-License-Identifier: Apache-2.0
#include "mutants/in_tuning.hpp"

#include <algorithm>

#include "mutants/on_forms.hpp"
#include "systems/schemes.hpp"

namespace polhode::test {
namespace {

/// Shears in place of turns, from the turns' constants.
void make_shears(rigid_body_constants& k) {
  for (int n = 1; n <= 2; ++n)
    for (int axis = 0; axis < 3; ++axis) k.first_turns[n - 1][axis] = shear_rotation<2>(k.shifted[axis] / n, k.radius);
  k.last_half_turn = shear_rotation<1>(k.shifted[2] / 2, k.radius);
}

rigid_body_constants spoilt(rigid_body_constants k, const defect& d, rotation_size size) {
  switch (d.kind) {
    case kind::dissipation_sign: return {k.inverse_inertia, -k.theta, k.dt, k.radius, size};
    case kind::half_turn: k.shifted[2] *= 1 + d.size; break;
    case kind::casimir_shift:
      for (int axis = 0; axis < 3; ++axis)
        k.shifted[axis] = k.dt * (k.inverse_inertia[axis] - k.inverse_inertia[static_cast<int>(d.size) - 1]);
      break;
    case kind::damping_halved: k.damping_to_unit[0] = k.damping_to_unit[1]; break;
    default: break;
  }
  if (size == rotation_size::tiny) make_shears(k);
  if (d.kind == kind::half_shear) k.last_half_turn = shear_rotation<1>(k.shifted[2] / 2 * (1 + d.size), k.radius);
  return k;
}

/// The normalising polynomial, so many degrees short where there is one.
template <class Body>
auto normalisation_of(const rigid_body_constants& k, const defect& d) {
  auto whole = Body::template normalisation<Body::norm_degree>(k);
  if constexpr (Body::norm_degree > 0)
    if (d.kind == kind::normalisation) {
      const auto cut = Body::template normalisation<Body::norm_degree - 1>(k);
      *std::ranges::copy(cut, whole.begin()).out = 0;
    }
  return whole;
}

template <class Scheme>
std::unique_ptr<kernel> tuned(chosen_step s, const defect& d) {
  if (d.kind == kind::reach && s.size > rotation_size::tiny)
    s.size = static_cast<rotation_size>(static_cast<int>(s.size) - 1);
  return kernel_on_forms<Scheme, Scheme>(s, [&]<body_parts parts, rotation_size size>() {
    using body = rigid_body_at<parts, size, no_noise>;
    const auto constants = spoilt(constants_of(s.body, s.dt, s.radius, 0, size), d, size);
    return rigid_body_forms<parts, size>(s.body, body(constants, normalisation_of<body>(constants, d), {}), 0);
  });
}

}  // namespace

std::unique_ptr<kernel> defective_tuning(const report::scene& scene, std::string_view scheme, const defect& d,
                                         double dt) {
  const auto s = chosen_for(scene, dt);
  if (scheme == heun::info.name) return tuned<heun>(s, d);
  if (scheme == lie_heun::info.name) return tuned<lie_heun>(s, d);
  if (scheme == lie_trotter::info.name) return tuned<lie_trotter>(s, d);
  if (scheme == strang::info.name) return tuned<strang>(s, d);
  throw std::invalid_argument("no defect of the tuning is compiled for this scheme");
}

}  // namespace polhode::test
