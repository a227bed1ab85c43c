// SPDX-License-Identifier: Apache-2.0
// The loops around a scheme's step, compiled for packs. Instantiated where a system is bound, in src/systems, alone.
//
// Steps are the outer loop, packs the inner one: the packs of a block are independent of each other, so the chain of
// dependent operations in one pack's step is hidden behind the others'. The states of a block and the increments of a
// chunk of steps stay in the nearest cache.
#pragma once

#include <array>
#include <utility>

#include <polhode/schemes/scheme_info.hpp>
#include <polhode/simd.hpp>

#include <polhode/flatten.hpp>
#include "ensemble/kernel.hpp"
#include "platform/work_counters.hpp"

namespace polhode {

/// n: components of a vector whose type leaves that open.
template <class S, int N, class Real>
vec<S, N> load_lanes(const Real* at, int n = N) {
  auto v = zeros<vec<S, N>>(n);
  for (int k = 0; k < v.size; ++k) v[k].copy_from(at + k * block_lanes, stdx::element_aligned);
  return v;
}

template <class S, int N>
void store_lanes(const vec<S, N>& v, double* at) {
  for (int k = 0; k < v.size; ++k) v[k].copy_to(at + k * block_lanes, stdx::element_aligned);
}

/// The increment of a block's lanes at a place of [step][channel][lane], but for the factor unit_of(view).
template <class S, int N>
vec<S, N> load_scaled_increment(const increment_view& view, std::ptrdiff_t at, int n = N) {
  return view.singles.empty() ? load_lanes<S, N>(view.dw.data() + at, n)
                              : load_lanes<S, N>(view.singles.data() + at, n);
}
inline double unit_of(const increment_view& view) { return view.singles.empty() ? 1 : view.scale; }

template <class S, int N>
vec<S, N> load_increment(const increment_view& view, std::ptrdiff_t at, int n = N) {
  return S(unit_of(view)) * load_scaled_increment<S, N>(view, at, n);
}

/// Two packs whose operations alternate and hide each other's latency.
using two_packs = stdx::fixed_size_simd<double, static_cast<int>(2 * pack::size())>;

/// The scalar of the rigid body's loops: two packs, but one where that leaves too few registers (measured: with AVX2
/// two are slower, with SSE and AVX-512 faster).
using loop_pack = std::conditional_t<pack::size() == 4, pack, two_packs>;

/// Forms: a system in the forms in which the loops need it (plain_forms.hpp is the simplest).
///   own(unit): for paths with increments of their own, in units of `unit`; take(view, scratch) brings them into the
///   form it expects
///   silent(): without noise
///   share(view): the table of a common noise;   common(): a system that enter(system, row, dt) puts into the step of a
///   row of that table, and that takes the increment which enter returns axis(k): the row of the states that is
///   component k of the system
template <class Scheme, class Forms, class S>
class kernel_of final : public kernel {
 public:
  /// dt: of every step, and of all that the forms hold ready for one.
  kernel_of(Forms forms, double dt) : forms_(std::move(forms)), dt_(dt) {}

  double dt() const override { return dt_; }

  POLHODE_FLATTEN void advance(std::span<double> states, const increment_view& given, piece p) const override {
    const double dt = dt_;
    count_path_steps(static_cast<std::uint64_t>(given.steps) * block_lanes, Scheme::info.name.data());
    if (given.silent()) {
      const auto system = forms_.silent();
      run(rows_of(states), given.steps, dt, p,
          [&](std::int64_t, auto&& pass) { pass(system, [dt](int) { return levy(dt); }); });
      return;
    }
    std::vector<double> scratch;
    const increment_view view = forms_.take(given, scratch);
    const auto system = forms_.own(unit_of(view));
    const int channels = channels_of(system), pairs = pairs_among(channels);
    run(rows_of(states), given.steps, dt, p, [&](std::int64_t i, auto&& pass) {
      pass(system, [=, &view](int lane) {
        auto w = levy(dt);
        w.dw = load_scaled_increment<S, most_channels>(view, i * channels * block_lanes + lane, channels);
        if constexpr (needs_areas_on<Scheme, own_system>)
          w.area = load_lanes<S, most_pairs>(view.area.data() + i * pairs * block_lanes + lane, pairs);
        return w;
      });
    });
  }

  shared_steps share(const increment_view& one_path) const override { return forms_.share(one_path); }

  POLHODE_FLATTEN void advance(std::span<double> states, const shared_steps& noise, std::int64_t first_step,
                               std::int64_t steps, piece p) const override {
    count_path_steps(static_cast<std::uint64_t>(steps) * block_lanes, Scheme::info.name.data());
    const double dt = dt_;
    const double* row = noise.table.data() + static_cast<std::size_t>(first_step) * noise.words;
    auto system = forms_.common();
    run(rows_of(states), steps, dt, p, [&](std::int64_t, auto&& pass) {
      const auto w = forms_.template enter<S>(system, row, dt);
      row += noise.words;
      pass(system, [w = w](int) { return w; });
    });
  }

  POLHODE_FLATTEN void finish(std::span<double> states) const override { close(rows_of(states), dt_); }

 private:
  using own_system = std::remove_cvref_t<decltype(std::declval<const Forms&>().own(1.0))>;
  static constexpr int dimension = own_system::dimension, most_channels = own_system::channels,
                       most_pairs = pairs_of<most_channels>;
  static constexpr int width = static_cast<int>(S::size());
  static_assert(block_lanes % width == 0);

  static wiener_levy<S, most_channels> levy(double dt) {
    wiener_levy<S, most_channels> w;
    w.dt = dt;
    return w;
  }

  /// Where each component of the system lies in the states.
  using rows = vec<double*, dimension>;
  rows rows_of(std::span<double> states) const {
    auto out = zeros<rows>(static_cast<int>(states.size()) / block_lanes);
    for (int k = 0; k < out.size; ++k) out[k] = states.data() + forms_.axis(k) * block_lanes;
    return out;
  }
  static vec<S, dimension> load(const rows& from, int lane) {
    auto v = zeros<vec<S, dimension>>(from.size);
    for (int k = 0; k < v.size; ++k) v[k].copy_from(from[k] + lane, stdx::element_aligned);
    return v;
  }
  static void store(const vec<S, dimension>& v, const rows& to, int lane) {
    for (int k = 0; k < v.size; ++k) v[k].copy_to(to[k] + lane, stdx::element_aligned);
  }

  /// Every step of every lane. at(i, pass): calls pass(system, increment of a lane) for step i.
  template <class At>
  void run(const rows& states, std::int64_t steps, double dt, piece p, At at) const {
    std::int64_t i = 0;
    if constexpr (merges_on<Scheme, own_system>)
      if (p.first && steps > 0) {
        at(i, [&](const auto& system, auto increment) { over_lanes<half_step>(states, dt, system, increment); });
        ++i;
      }
    for (; i < steps; ++i)
      at(i, [&](const auto& system, auto increment) { over_lanes<whole_step>(states, dt, system, increment); });
    if (p.last && steps > 0) close(states, dt);
  }

  template <class Opening, class System, class Increment>
  static void over_lanes(const rows& states, double dt, const System& system, const Increment& increment) {
#pragma GCC unroll 1  // the body is long enough
    for (int lane = 0; lane < block_lanes; lane += width) {
      auto mu = load(states, lane);
      const auto w = increment(lane);
      if constexpr (merges_on<Scheme, System>)
        mu = Scheme::inner(system, Scheme::outer(system, mu, Opening{dt}), w);
      else
        mu = Scheme::step(system, mu, w);
      store(mu, states, lane);
    }
  }

  void close(const rows& states, double dt) const {
    if constexpr (merges_on<Scheme, own_system>) {
      const auto system = forms_.silent();
#pragma GCC unroll 1
      for (int lane = 0; lane < block_lanes; lane += width)
        store(Scheme::outer(system, load(states, lane), half_step{dt}), states, lane);
    }
  }

  Forms forms_;
  double dt_;
};

}  // namespace polhode
