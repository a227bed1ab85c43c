// SPDX-License-Identifier: Apache-2.0
// A kernel that is compiled for one scheme on one system.
#pragma once

#include <memory>
#include <string_view>
#include <type_traits>
#include <vector>

#include "ensemble/kernel_of.hpp"
#include "ensemble/plain_forms.hpp"
#include "systems/schemes.hpp"

namespace polhode {

template <class Scheme>
struct scheme_tag {};

/// Ours keep to the rule that the system alone is asked what an increment does (polhode/systems/lie_poisson.hpp); of a
/// scheme that comes from elsewhere nobody knows.
template <class Scheme, class... Ours>
constexpr bool is_one_of(scheme_list<Ours...>) {
  return (std::is_same_v<Scheme, Ours> || ...);
}
template <class Scheme, class System>
using forms_for = plain_forms<System, is_one_of<Scheme>(all_schemes{})>;

/// The kernel of a scheme on a system at one step size, for states on the orbit of the momentum. A system with kernels
/// of its own overloads this.
template <class Scheme, class System>
std::unique_ptr<kernel> kernel_for(scheme_tag<Scheme>, const System& system, const std::vector<double>&, double dt) {
  using forms = forms_for<Scheme, decltype(prepared<Scheme>(system, dt))>;
  return std::make_unique<kernel_of<Scheme, forms, pack>>(forms(prepared<Scheme>(system, dt)), dt);
}

/// That of the scheme of this name, if it is one of these. Where an operation is so short, or a step asks for so many
/// of them, that a pass over memory each would take more than a third of the time again, a system has kernels of its
/// own beside its face.
template <class System, class... Schemes>
std::unique_ptr<kernel> kernel_among(scheme_list<Schemes...>, std::string_view name, const System& system,
                                     const std::vector<double>& momentum, double dt) {
  std::unique_ptr<kernel> out;
  ((Schemes::info.name == name ? void(out = kernel_for(scheme_tag<Schemes>{}, system, momentum, dt)) : void()), ...);
  return out;
}

}  // namespace polhode
