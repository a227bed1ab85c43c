// The loop around a scheme's step, compiled for packs. Instantiated in the registry alone.
#pragma once

#include <polhode/schemes/scheme_info.hpp>
#include <polhode/simd.hpp>

#include "ensemble/kernel.hpp"

namespace polhode {

template <class S, int N>
vec<S, N> load_lanes(const double* at) {
  vec<S, N> v;
  for (int k = 0; k < N; ++k) v[k].copy_from(at + k * block_lanes, stdx::element_aligned);
  return v;
}

template <class S, int N>
void store_lanes(const vec<S, N>& v, double* at) {
  for (int k = 0; k < N; ++k) v[k].copy_to(at + k * block_lanes, stdx::element_aligned);
}

/// System: already prepared by the scheme for the step size of the increments.
template <class Scheme, class System, class S = pack>
class kernel_of final : public kernel {
 public:
  explicit kernel_of(System system) : system_(std::move(system)) {}

  void advance(std::span<double> states, const increment_view& increments) const override {
    static_assert(block_lanes % static_cast<int>(S::size()) == 0);
    for (int lane = 0; lane < block_lanes; lane += static_cast<int>(S::size()))
      advance_lanes(states.data() + lane, lane, increments);
  }

 private:
  void advance_lanes(double* states, int lane, const increment_view& view) const {
    constexpr int channels = System::channels, pairs = pairs_of<channels>;
    auto mu = load_lanes<S, System::dimension>(states);
    const double* dw = view.dw.data() + lane;
    const double* area = view.area.data() + lane;
    for (int i = 0; i < view.steps; ++i, dw += channels * block_lanes) {
      wiener_levy<S, channels> w;
      w.dt = view.dt;
      w.dw = load_lanes<S, channels>(dw);
      if constexpr (needs_areas_on<Scheme, System>) {
        w.area = load_lanes<S, pairs>(area);
        area += pairs * block_lanes;
      }
      mu = Scheme::step(system_, mu, w);
    }
    store_lanes(mu, states);
  }

  System system_;
};

}  // namespace polhode
