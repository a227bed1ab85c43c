// SPDX-License-Identifier: Apache-2.0
// Binds a concrete system and concrete schemes into a subject: for the sources of the systems, and for tests that bring
// a system of their own or a planted defect.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "ensemble/kernel_of.hpp"
#include "ensemble/plain_forms.hpp"
#include "ensemble/tangent_kernel_of.hpp"
#include <polhode/flatten.hpp>
#include "problem/subject.hpp"
#include "references/wong_zakai_equation.hpp"
#include "systems/schemes.hpp"

namespace polhode {

template <lie_poisson_system System>
class model_of final : public model {
 public:
  static constexpr int n = System::dimension, m = System::channels;
  explicit model_of(System system) : system_(std::move(system)) {}

  int dimension() const override { return dimension_of(system_); }
  noise_layout layout() const override { return {channels_of(system_), system_.active_channels()}; }
  noise_class noise() const override { return system_.classify(); }
  double energy(std::span<const double> mu) const override { return system_.energy(state(mu)); }
  double dissipation_rate(std::span<const double> mu) const override { return system_.dissipation_rate(state(mu)); }
  std::vector<double> casimirs(std::span<const double> mu) const override {
    const auto c = System::algebra::casimirs(state(mu));
    return {c.begin(), c.end()};
  }
  std::vector<double> casimir_sizes(std::span<const double> mu) const override {
    using g = typename System::algebra;
    if constexpr (requires { g::casimir_sizes(state(mu)); }) {
      const auto c = g::casimir_sizes(state(mu));
      return {c.begin(), c.end()};
    } else {
      auto sizes = casimirs(mu);
      for (double& c : sizes) c = std::fabs(c);
      return sizes;
    }
  }
  POLHODE_FLATTEN void conserved(std::span<const double> states, std::span<double> energies,
                                 std::span<double> casimirs) const override {
    for (int lane = 0; lane < block_lanes; lane += static_cast<int>(pack::size())) {
      const auto mu = load_lanes<pack, n>(states.data() + lane, dimension());
      pack(system_.energy(mu)).copy_to(energies.data() + lane, stdx::element_aligned);
      store_lanes(System::algebra::casimirs(mu), casimirs.data() + lane);
    }
  }
  void drift(std::span<const double> mu, std::span<double> out) const override {
    const auto x = state(mu);
    std::ranges::copy(System::algebra::coad(system_.generator(x), x), out.begin());
  }
  POLHODE_FLATTEN void drifts(std::span<const double> states, std::span<double> out) const override {
    for (int lane = 0; lane < block_lanes; lane += static_cast<int>(pack::size())) {
      const auto mu = load_lanes<pack, n>(states.data() + lane, dimension());
      store_lanes(System::algebra::coad(system_.generator(mu), mu), out.data() + lane);
    }
  }
  void coadjoint(std::span<const double> xi, std::span<const double> mu, std::span<double> out) const override {
    std::ranges::copy(System::algebra::coad(state(xi), state(mu)), out.begin());
  }
  POLHODE_FLATTEN void coarsen(const increment_view& fine, int factor, std::span<double> dw,
                               std::span<double> area) const override {
    const int channels = channels_of(system_), pairs = pairs_among(channels);
    const auto at = [&](int i, int lane) {
      wiener_levy<pack, m> w;
      w.dw = load_increment<pack, m>(fine, i * channels * block_lanes + lane, channels);
      w.area = zeros<decltype(w.area)>(pairs);
      if (!fine.area.empty())
        w.area = load_lanes<pack, pairs_of<m>>(fine.area.data() + i * pairs * block_lanes + lane, pairs);
      return w;
    };
    for (int k = 0; k < fine.steps / factor; ++k)
      for (int lane = 0; lane < block_lanes; lane += static_cast<int>(pack::size())) {
        auto sum = at(k * factor, lane);
        for (int i = 1; i < factor; ++i) sum = chen(sum, at(k * factor + i, lane));
        store_lanes(sum.dw, dw.data() + k * channels * block_lanes + lane);
        store_lanes(sum.area, area.data() + k * pairs * block_lanes + lane);
      }
  }
  std::unique_ptr<kernel> reference(double dt) const override {
    return std::make_unique<kernel_of<wong_zakai_equation, plain_forms<System>, pack>>(plain_forms(system_), dt);
  }

 private:
  static vec<double, n> state(std::span<const double> mu) {
    auto x = zeros<vec<double, n>>(static_cast<int>(mu.size()));
    std::ranges::copy(mu.first(static_cast<std::size_t>(x.size)), x.begin());
    return x;
  }
  System system_;
};

/// What the system that the scene names offers there; nothing where it names none.
std::shared_ptr<const capabilities> offers_of(const report::scene&);

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
  subject out{s, std::make_shared<model_of<std::remove_const_t<decltype(system)>>>(system), offers_of(s), {}, {}, {}};
  (add_scheme<Schemes>(out, system), ...);
  out.with = [make_system, schemes](const report::scene& other) { return bind(other, make_system, schemes); };
  return out;
}

}  // namespace polhode
