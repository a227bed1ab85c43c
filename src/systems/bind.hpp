// SPDX-License-Identifier: Apache-2.0
// Binds a concrete system and concrete schemes into a subject, each scheme compiled for that system: for a system or a
// scheme of one's own in C++, and for planted defects. The systems and schemes of the laboratory meet behind faces
// (faced_system.hpp).
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "ensemble/chen.hpp"
#include "ensemble/tangent_kernel_of.hpp"
#include "problem/subject.hpp"
#include "references/wong_zakai_equation.hpp"
#include "systems/kernel_for.hpp"
#include "systems/model_of.hpp"
#include "systems/systems.hpp"

namespace polhode {

/// A system whose reference is a loop of its own.
template <lie_poisson_system System>
class fused_model final : public model_of<System, model> {
 public:
  using model_of<System, model>::model_of;

  void coarsen(const increment_view& fine, int factor, std::span<double> dw, std::span<double> area) const override {
    polhode::coarsen(this->layout(), fine, factor, dw, area);
  }
  std::unique_ptr<kernel> reference(double dt) const override {
    using forms = plain_forms<System>;
    return std::make_unique<kernel_of<wong_zakai_equation, forms, pack>>(forms(this->system()), dt);
  }
};

template <class Scheme, class System>
std::unique_ptr<tangent_kernel> tangent_kernel_for(const System& system, double dt) {
  auto stepped = prepared<Scheme>(system, dt);
  return std::make_unique<tangent_kernel_of<Scheme, decltype(stepped)>>(std::move(stepped), dt);
}

struct another_step {
  static void step();
};
template <class Scheme>
struct with_another_step : Scheme, another_step {};
/// Whether it has anything of that name: two would not be told apart.
template <class Scheme>
inline constexpr bool has_step = !requires {
  &with_another_step<Scheme>::step;
};

template <class Scheme, class System>
void add_scheme(subject& out, const System& system) {
  static_assert(
      requires { Scheme::info.name; }, "a scheme needs `static constexpr polhode::scheme_info info`");
  static_assert(has_step<Scheme>, "a scheme needs `static auto step(const System& system, const vec<S, n>& mu, w)`");
  if constexpr (requires { requires scheme_on<Scheme, System>; }) {
    out.schemes.push_back({Scheme::info, needs_areas_on<Scheme, System>,
                           [system, momentum = out.scene.momentum](double dt) -> std::unique_ptr<kernel> {
                             return kernel_for(scheme_tag<Scheme>{}, system, momentum, dt);
                           },
                           [system](double dt) { return tangent_kernel_for<Scheme>(system, dt); }});
  } else {
    using increment = wiener_levy<double, System::channels>;
    static_assert(
        !requires(const state_of<System>& mu, const increment& w) { Scheme::step(system, mu, w); },
        "the step of a scheme returns a state: vec<S, n> of the scalars S that it was given");
    std::string why = !is_one_of<Scheme>(all_schemes{}) ? "its step does not take this system"
                      : constant_noise_system<System>
                          ? "the system does not split into flows"
                          : "needs a system of flows, or noise vectors that do not depend on the state";
    if constexpr (requires { Scheme::needs; }) why = fmt::format("needs {}", Scheme::needs);
    out.inapplicable.push_back({"", std::string(Scheme::info.name), why});
  }
}

/// make_system: report::scene -> System.
template <class MakeSystem, class... Schemes>
subject bind(const report::scene& s, MakeSystem make_system, scheme_list<Schemes...> schemes) {
  const auto system = make_system(s);
  subject out{s, std::make_shared<fused_model<std::remove_const_t<decltype(system)>>>(system), offers_of(s), {}, {},
              {}};
  (add_scheme<Schemes>(out, system), ...);
  out.with = [make_system, schemes](const report::scene& other) { return bind(other, make_system, schemes); };
  return out;
}

}  // namespace polhode
