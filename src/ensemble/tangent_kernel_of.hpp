// SPDX-License-Identifier: Apache-2.0
// The tangents of a scheme's own step, by dual numbers: no derivative is written by hand. One form of the system for
// every scene and step size, as a derivative is worth no specialisation. Instantiated where a system is bound, in
// src/systems, alone.
#pragma once

#include <utility>

#include <polhode/dual.hpp>

#include "ensemble/kernel_of.hpp"
#include "ensemble/tangent_kernel.hpp"
#include <polhode/flatten.hpp>

namespace polhode {

template <class Scheme, class System>
class tangent_kernel_of final : public tangent_kernel {
 public:
  tangent_kernel_of(System system, double dt) : system_(std::move(system)), dt_(dt) {}

  double dt() const override { return dt_; }

  void advance(std::span<double> states, std::span<double> tangents, const increment_view& view) const override {
    count_path_steps(static_cast<std::uint64_t>(view.steps) * block_lanes, Scheme::info.name.data());
    for (int i = 0; i < view.steps; ++i)
      for (int lane = 0; lane < block_lanes; lane += static_cast<int>(pack::size()))
        step(states.data() + lane, tangents.data() + lane, increment(view, i, lane));
  }

 private:
  static constexpr int dimension = System::dimension;
  using number = dual<pack, tangent_vectors>;
  using increments = wiener_levy<number, System::channels>;

  increments increment(const increment_view& view, int i, int lane) const {
    const int channels = channels_of(system_), pairs = pairs_among(channels);
    increments w;
    w.dt = dt_;
    if (view.silent()) return w;
    w.dw =
        constant_of<number>(load_increment<pack, System::channels>(view, i * channels * block_lanes + lane, channels));
    if constexpr (needs_areas_on<Scheme, System>)
      w.area = constant_of<number>(
          load_lanes<pack, pairs_of<System::channels>>(view.area.data() + i * pairs * block_lanes + lane, pairs));
    return w;
  }

  POLHODE_FLATTEN void step(double* state, double* tangent, const increments& w) const {
    const int n = dimension_of(system_), next_vector = n * block_lanes;
    auto mu = constant_of<number>(load_lanes<pack, dimension>(state, n));
    for (int t = 0; t < tangent_vectors; ++t) {
      const auto slope = load_lanes<pack, dimension>(tangent + t * next_vector, n);
      for (int k = 0; k < n; ++k) mu[k].slope[t] = slope[k];
    }
    mu = Scheme::step(system_, mu, w);
    for (int k = 0; k < n; ++k) {
      mu[k].value.copy_to(state + k * block_lanes, stdx::element_aligned);
      for (int t = 0; t < tangent_vectors; ++t)
        mu[k].slope[t].copy_to(tangent + t * next_vector + k * block_lanes, stdx::element_aligned);
    }
  }

  System system_;
  double dt_;
};

}  // namespace polhode
