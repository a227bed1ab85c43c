// SPDX-License-Identifier: Apache-2.0
// A system's struct behind the functions of `model` that measure a state.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include <polhode/flatten.hpp>

#include "ensemble/kernel_of.hpp"
#include "ensemble/model.hpp"

namespace polhode {

/// What a system's struct says of a state, as the virtual functions of Base: model, or a class that derives from it.
template <lie_poisson_system System, class Base>
class model_of : public Base {
 public:
  static constexpr int n = System::dimension;
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

 protected:
  const System& system() const { return system_; }

 private:
  static vec<double, n> state(std::span<const double> mu) {
    auto x = zeros<vec<double, n>>(static_cast<int>(mu.size()));
    std::ranges::copy(mu.first(static_cast<std::size_t>(x.size)), x.begin());
    return x;
  }
  System system_;
};

}  // namespace polhode
