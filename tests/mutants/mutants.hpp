// Planted defects. Each is a scheme of the list with one thing wrong; the laboratory must refute it by name.
#pragma once

#include <bit>

#include "registry/schemes.hpp"
#include "support/schemes.hpp"

namespace polhode::test {

/// The claims of Scheme under another name.
template <class Scheme>
constexpr scheme_info posing_as(std::string_view name) {
  auto info = Scheme::info;
  info.name = name;
  return info;
}

/// The sign of the Levy area flipped.
template <class Scheme>
struct area_sign_flipped {
  static constexpr auto info = posing_as<Scheme>("area_sign_flipped");
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, wiener_levy<S, System::channels> w) {
    w.area = -w.area;
    return Scheme::step(system, mu, w);
  }
};

/// Areas of the right law, but drawn anew at every level instead of taken from the path.
struct areas_redrawn {
  static constexpr auto info = posing_as<magnus>("areas_redrawn");
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, wiener_levy<S, System::channels> w) {
    for (int pair = 0; pair < w.area.size; ++pair) {
      const auto redrawn = [&](double dw) {
        const auto bits = std::bit_cast<std::uint64_t>(dw);
        return w.dt / 2 * normals<1>({99, noise_kind::area, bits % (1ull << 48), static_cast<std::uint64_t>(pair)})[0];
      };
      const auto in_every_lane = [&]<class Lanes>(const Lanes& dw) {
        if constexpr (is_pack<Lanes>)
          return Lanes([&](auto lane) { return redrawn(dw[lane]); });
        else
          return redrawn(dw);
      };
      if constexpr (requires { w.dw[0].slope; })
        w.area[pair].value = in_every_lane(w.dw[0].value);
      else
        w.area[pair] = in_every_lane(w.dw[0]);
    }
    return magnus::step(system, mu, w);
  }
};

/// Euler-Maruyama without the Ito drift.
struct ito_correction_missing {
  static constexpr auto info = posing_as<euler_maruyama>("ito_correction_missing");
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    return mu + System::algebra::coad(generator(system, mu, w), mu);
  }
};

/// The sign of the dissipation as the paper prints it.
template <class Scheme>
struct printed_dissipation_sign {
  static constexpr auto info = posing_as<Scheme>("printed_dissipation_sign");
  template <class System, class S>
  static auto step(System system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    system.theta = -system.theta;
    return Scheme::step(system, mu, w);
  }
};

/// Noise of twice the variance.
template <class Scheme>
struct noise_variance_doubled {
  static constexpr auto info = posing_as<Scheme>("noise_variance_doubled");
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, wiener<S, System::channels> w) {
    w.dw = S(std::sqrt(2.0)) * w.dw;
    return Scheme::step(system, mu, w);
  }
};

/// Lie-Euler with the exponential cut after the second power.
struct exponential_truncated {
  static constexpr auto info = posing_as<lie_euler>("exponential_truncated");
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const auto xi = generator(system, mu, w);
    const auto once = System::algebra::coad(xi, mu);
    return mu + once + S(0.5) * System::algebra::coad(xi, once);
  }
};

/// Strang with its second half not mirrored: Lie-Trotter twice.
struct halves_not_mirrored {
  static constexpr auto info = posing_as<strang>("halves_not_mirrored");
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const double half = w.dt / 2;
    const auto before = system.free_flow(system.dissipation_flow(mu, half), half);
    const auto after = System::algebra::exp_action(system.noise(w.dw), before);
    return system.free_flow(system.dissipation_flow(after, half), half);
  }
};

/// Lie-Heun whose second stage takes the drift at the old state.
struct drift_at_wrong_stage {
  static constexpr auto info = posing_as<lie_heun>("drift_at_wrong_stage");
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    const auto first = generator(system, mu, w), second = generator(system, mu, w);
    return System::algebra::exp_action(S(0.5) * (first + second), mu);
  }
};

/// Heun of the Stratonovich equation given the Ito drift as well.
struct ito_drift_added {
  static constexpr auto info = posing_as<heun>("ito_drift_added");
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    return heun::step(system, mu, w) + S(w.dt) * system.ito_drift(mu);
  }
};

/// Strang with the noise vectors as they are, under the claims of strang_weak2.
struct noise_not_scaled {
  static constexpr auto info = posing_as<strang_weak2>("noise_not_scaled");
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    return strang::step(system, mu, w);
  }
};

}  // namespace polhode::test
