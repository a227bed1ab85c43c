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
      if (increments.shared)
        advance_lanes(states.data() + lane, increments.dt, increments.steps,
                      reader<true>{increments.dw.data(), increments.area.data()});
      else
        advance_lanes(states.data() + lane, increments.dt, increments.steps,
                      reader<false>{increments.dw.data() + lane, increments.area.data() + lane});
  }

 private:
  static constexpr int channels = System::channels, pairs = pairs_of<channels>;

  /// Reads one step's increments after another: every lane its own, or one for all.
  template <bool shared>
  struct reader {
    const double* dw;
    const double* area;
    static constexpr int stride = shared ? 1 : block_lanes;

    template <int N>
    static vec<S, N> take(const double*& at) {
      vec<S, N> v;
      for (int k = 0; k < N; ++k, at += stride)
        if constexpr (shared)
          v[k] = S(*at);
        else
          v[k].copy_from(at, stdx::element_aligned);
      return v;
    }
  };

  /// Flattened: one call left in this loop costs more than the step.
  template <class Reader>
  [[gnu::flatten]] void advance_lanes(double* states, double dt, int steps, Reader increments) const {
    auto mu = load_lanes<S, System::dimension>(states);
    for (int i = 0; i < steps; ++i) {
      wiener_levy<S, channels> w;
      w.dt = dt;
      w.dw = Reader::template take<channels>(increments.dw);
      if constexpr (needs_areas_on<Scheme, System>) w.area = Reader::template take<pairs>(increments.area);
      mu = Scheme::step(system_, mu, w);
    }
    store_lanes(mu, states);
  }

  System system_;
};

}  // namespace polhode
