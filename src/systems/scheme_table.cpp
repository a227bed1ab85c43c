// SPDX-License-Identifier: Apache-2.0
#include "systems/scheme_table.hpp"

#include <fmt/format.h>

#include <memory>
#include <utility>

#include "ensemble/tapes/taped.hpp"
#include "references/wong_zakai_equation.hpp"
#include "systems/schemes.hpp"

namespace polhode {
namespace {

constexpr taped_traits with(taped_noise noise) {
  taped_traits out;
  out.noise = noise;
  return out;
}
constexpr taped_traits everything{}, without_turns{.turns = false}, without_flows{.flows = false, .turns = false},
    without_matrices{.matrices = false};

/// Whether the scheme steps a system with these traits.
template <class Scheme, taped_traits traits>
inline constexpr bool steps = scheme_on<Scheme, taped_system<traits>>;

template <class Scheme>
constexpr bool steps_under(taped_noise noise) {
  switch (noise) {
    case taped_noise::none: return steps<Scheme, with(taped_noise::none)>;
    case taped_noise::constant: return steps<Scheme, everything>;
    case taped_noise::varying: return steps<Scheme, with(taped_noise::varying)>;
    case taped_noise::unbracketed: return steps<Scheme, with(taped_noise::unbracketed)>;
  }
  return false;
}

template <class Scheme>
std::string inapplicable(const taped_traits& t) {
  const bool flows = t.flows || steps<Scheme, without_flows>, turns = t.turns || steps<Scheme, without_turns>,
             matrices = t.matrices || steps<Scheme, without_matrices>, noise = steps_under<Scheme>(t.noise);
  if (flows && turns && matrices && noise) return "";
  if constexpr (requires { Scheme::needs; }) return fmt::format("needs {}", Scheme::needs);
  return noise ? "the system does not split into flows"
               : "needs a system of flows, or noise vectors that do not depend on the state";
}

template <class Scheme>
double weak_order_two_at(double dt) {
  return prepared<Scheme>(taped_system<everything>{}, dt).weak_order_two_at;
}

/// What a step is written of: the state before it, and what it makes of it.
template <class System, class Step>
recorded_step recorded(double dt, Step step) {
  return [=](tape_recorder& recorder) {
    wiener_levy<taped, System::channels> w;
    w.dt = dt;
    w.area = {&recorder};
    recorder.finish(step(System{}, typename System::vector(recorder.start()), w).form());
  };
}

/// What is known of a tape at run time. fixed: the components of a system that always has so many, or -1.
struct tape_size {
  int fixed, components, tangents;
  double dt;
  bool exact_dissipation, joins;
};

template <class Scheme, taped_traits traits>
step_tapes tapes_on(const tape_size& size) {
  using system = taped_system<traits>;
  const auto taped_step = [&](auto step) {
    return std::make_shared<const tape>(size.components, size.tangents, size.joins, recorded<system>(size.dt, step));
  };
  step_tapes out;
  if constexpr (merges_on<Scheme, system>)
    if (size.tangents == 0) {
      const half_step half{size.dt};
      const whole_step whole{size.dt};
      out.opening = taped_step([=](const auto& s, const auto& mu, const auto& w) {
        return Scheme::inner(s, Scheme::outer(s, mu, half), w);
      });
      out.following = taped_step([=](const auto& s, const auto& mu, const auto& w) {
        return Scheme::inner(s, Scheme::outer(s, mu, whole), w);
      });
      out.closing = taped_step([=](const auto& s, const auto& mu, const auto&) { return Scheme::outer(s, mu, half); });
      return out;
    }
  out.opening = out.following =
      taped_step([](const auto& s, const auto& mu, const auto& w) { return Scheme::step(s, mu, w); });
  return out;
}

/// The traits with one known to the compiler, where the scheme can tell.
template <class Scheme, taped_traits traits>
step_tapes at_components(const tape_size& size) {
  constexpr auto of = [](int n) {
    taped_traits t = traits;
    t.components = n;
    return t;
  };
  if constexpr (Scheme::info.implicit) {  // it solves equations by a matrix of that size
    if (size.tangents == 0 && size.fixed == 3) return tapes_on<Scheme, of(3)>(size);
    if (size.tangents == 0 && size.fixed == 6) return tapes_on<Scheme, of(6)>(size);
  }
  return tapes_on<Scheme, traits>(size);
}
template <class Scheme, taped_noise noise>
step_tapes at_dissipation(const tape_size& size) {
  constexpr taped_traits approximate{.noise = noise, .exact_dissipation = false};
  if constexpr (merges_on<Scheme, taped_system<with(noise)>> != merges_on<Scheme, taped_system<approximate>>)
    if (!size.exact_dissipation) return at_components<Scheme, approximate>(size);
  return at_components<Scheme, with(noise)>(size);
}
template <class Scheme, taped_noise noise>
step_tapes under(const tape_size& size) {
  if constexpr (steps_under<Scheme>(noise))
    return at_dissipation<Scheme, noise>(size);
  else
    throw std::logic_error(fmt::format("{} does not step such a system", Scheme::info.name));
}

template <class Scheme>
scheme_tapes tapes(const taped_traits& t, int components, int tangents, double dt) {
  const tape_size size{t.components, components, tangents, dt, t.exact_dissipation, t.joins};
  const auto noisy = [&] {
    switch (t.noise) {
      case taped_noise::varying: return under<Scheme, taped_noise::varying>(size);
      case taped_noise::unbracketed: return under<Scheme, taped_noise::unbracketed>(size);
      default: return under<Scheme, taped_noise::constant>(size);
    }
  };
  return {Scheme::info.name, noisy(), under<Scheme, taped_noise::none>(size)};
}

template <class... Schemes>
std::vector<scheme_row> rows_of(scheme_list<Schemes...>) {
  return {{Schemes::info, needs_areas_on<Schemes, taped_system<everything>>, inapplicable<Schemes>,
           weak_order_two_at<Schemes>, tapes<Schemes>}...};
}

}  // namespace

const std::vector<scheme_row>& scheme_table() {
  static const auto rows = rows_of(all_schemes{});
  return rows;
}

scheme_tapes wong_zakai_tapes(const taped_traits& t, int components, double dt) {
  return tapes<wong_zakai_equation>(t, components, 0, dt);
}

}  // namespace polhode
