// SPDX-License-Identifier: Apache-2.0
// The face of a system's struct: a loop over the packs of a group around each of its functions. Instantiated once a
// system for packs, and once for packs with tangents.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <utility>

#include <polhode/dual.hpp>
#include <polhode/flatten.hpp>
#include <polhode/simd.hpp>
#include <polhode/systems/lie_poisson.hpp>

#include "ensemble/faces/face.hpp"
#include "ensemble/kernel_of.hpp"
#include "ensemble/plain_forms.hpp"

namespace polhode {

/// Vectors of a scalar S between rows of lanes and registers. The tangents of a dual number lie behind the values.
template <class S>
struct lane_rows {
  static constexpr int tangents = 0, width = static_cast<int>(S::size());

  template <int N>
  static vec<S, N> load(const double* at, int stride, int n) {
    auto v = zeros<vec<S, N>>(n);
    for (int k = 0; k < v.size; ++k) v[k].copy_from(at + k * stride, stdx::element_aligned);
    return v;
  }
  /// Rows without tangents.
  template <int N>
  static vec<S, N> load_values(const double* at, int stride, int n) {
    return load<N>(at, stride, n);
  }
  template <int N>
  static void store(const vec<S, N>& v, double* at, int stride) {
    for (int k = 0; k < v.size; ++k) v[k].copy_to(at + k * stride, stdx::element_aligned);
  }
};

template <class S, int T>
struct lane_rows<dual<S, T>> {
  using number = dual<S, T>;
  static constexpr int tangents = T, width = lane_rows<S>::width;

  template <int N>
  static vec<number, N> load(const double* at, int stride, int n) {
    auto v = load_values<N>(at, stride, n);
    for (int k = 0; k < v.size; ++k)
      for (int t = 0; t < T; ++t) v[k].slope[t].copy_from(at + ((t + 1) * n + k) * stride, stdx::element_aligned);
    return v;
  }
  template <int N>
  static vec<number, N> load_values(const double* at, int stride, int n) {
    auto v = zeros<vec<number, N>>(n);
    for (int k = 0; k < v.size; ++k) v[k].value.copy_from(at + k * stride, stdx::element_aligned);
    return v;
  }
  template <int N>
  static void store(const vec<number, N>& v, double* at, int stride) {
    const int n = v.size;
    for (int k = 0; k < n; ++k) {
      v[k].value.copy_to(at + k * stride, stdx::element_aligned);
      for (int t = 0; t < T; ++t) v[k].slope[t].copy_to(at + ((t + 1) * n + k) * stride, stdx::element_aligned);
    }
  }
};

/// S: the scalar, a pack or dual numbers of packs. K: lanes of a group.
template <class System, class S = pack, int K = block_lanes>
class face_of : public face {
  static constexpr int N = System::dimension, M = System::channels, P = pairs_of<M>;
  static constexpr bool fixed_noise = constant_noise_system<System>;
  using g = typename System::algebra;
  static constexpr bool matrices = requires(const vec<S, N>& a) { g::sandwich(a, a); };
  using io = lane_rows<S>;

 protected:
  using state = vec<S, N>;
  using kind = step_noise::kind;

 public:
  face_of(System system, double dt) : s_(std::move(system)), dt_(dt) {}

  double dt() const final { return dt_; }
  int components() const final { return dimension_of(s_); }
  int tangents() const final { return io::tangents; }
  int channels() const final { return channels_of(s_); }
  int lanes() const final { return K; }

  int noise_rows() const final { return fixed_noise ? components() : channels_of(s_); }
  /// sum sigma_i dW^i; where the vectors depend on the state, dW as it is.
  POLHODE_FLATTEN void take(const drawn_increments& w, double* rows) const final {
    const int channels = channels_of(s_);
    packs([&](int lane) {
      const auto dw = w.singles == nullptr ? load_lanes<pack, M>(w.dw + lane, channels)
                                           : pack(w.scale) * load_lanes<pack, M>(w.singles + lane, channels);
      if constexpr (fixed_noise)
        lane_rows<pack>::store(s_.noise(dw), rows + lane, K);
      else
        lane_rows<pack>::store(dw, rows + lane, K);
    });
  }
  shared_steps share(const increment_view& path) const override { return plain_forms<System, true>(s_).share(path); }

  POLHODE_FLATTEN void generator(const double* mu, const step_noise& w, double* xi) const override {
    const auto& s = held();
    with_noise(w, [&](auto noise) {
      each(mu, xi, [&](const state& x, int lane) -> state { return S(dt_) * s.generator(x) + noise(x, lane); });
    });
  }
  POLHODE_FLATTEN void drift(const double* mu, double* xi) const override {
    const auto& s = held();
    each(mu, xi, [&](const state& x, int) -> state { return S(dt_) * s.generator(x); });
  }
  POLHODE_FLATTEN void motion(const double* mu, const step_noise& w, double* out) const override {
    const auto& s = held();
    with_noise(w, [&](auto noise) {
      each(mu, out, [&](const state& x, int lane) -> state { return moved(s, x, noise(x, lane)); });
    });
  }
  POLHODE_FLATTEN void stage(const double* mu, const double* by, const double* c, const step_noise& w,
                             double* out) const override {
    if constexpr (io::tangents > 0) absent("a stage in one pass");
    const auto& s = held();
    const std::array<S, 4> a{S(c[0]), S(c[1]), S(c[2]), S(c[3])};
    with_noise(w, [&](auto noise) {
      each(mu, out, [&](const state& x, int lane) -> state {
        const auto y = load(by + lane);
        const state at = x + a[3] * y;
        return a[0] * x + a[1] * y + a[2] * moved(s, at, noise(at, lane));
      });
    });
  }

  POLHODE_FLATTEN void noise(const double* mu, const step_noise& w, double* out) const override {
    each(mu, out, [&](const state& x, int lane) { return noise_at(w, x, lane); });
  }
  POLHODE_FLATTEN void noise_slope([[maybe_unused]] const double* mu, [[maybe_unused]] const double* by,
                                   [[maybe_unused]] const step_noise& w, double* out) const override {
    if constexpr (!fixed_noise && bracketed_noise_system<System>)
      each(mu, out, [&](const state& x, int lane) -> state {
        return s_.noise_slope_at(x, increment(w, lane), load(by + lane));
      });
    else
      each(mu, out, [&](const state& x, int) { return zeros<state>(x.size); });
  }
  POLHODE_FLATTEN void noise_twice(const double* mu, const step_noise& w, double* out) const override {
    each(mu, out, [&](const state& x, int lane) -> state {
      if constexpr (fixed_noise) {
        const auto b = noise_at(w, x, lane);
        return g::coad(b, g::coad(b, x));
      } else if constexpr (bracketed_noise_system<System>) {
        return polhode::noise_twice(s_, x, increment(w, lane));
      } else {
        return absent("brackets of its noise");
      }
    });
  }
  POLHODE_FLATTEN void area_noise(const double* mu, const step_noise& w, double* out) const override {
    const int pairs = pairs_among(channels_of(s_));
    each(mu, out, [&](const state& x, int lane) -> state {
      if (w.of == kind::none) return zeros<state>(x.size);
      if constexpr (fixed_noise) {
        if (w.of == kind::shared) return detail::lifted<state>(w.rows + x.size, x.size);
        return s_.area_noise(io::template load_values<P>(w.area + lane, block_lanes, pairs));
      } else if constexpr (bracketed_noise_system<System>) {
        if (w.of == kind::shared)
          return s_.area_noise_at(x, detail::lifted<vec<S, P>>(w.rows + channels_of(s_), pairs));
        return s_.area_noise_at(x, io::template load_values<P>(w.area + lane, block_lanes, pairs));
      } else {
        return absent("brackets of its noise");
      }
    });
  }
  POLHODE_FLATTEN void ito_drift(const double* mu, double* out) const override {
    each(mu, out, [&](const state& x, int) -> state { return zeros<state>(x.size) + s_.ito_drift(x); });
  }
  POLHODE_FLATTEN void linearised_motion(const double* mu, const step_noise& w, double* value,
                                         double* slope) const override {
    differentiate(mu, w, value, slope, [&](const System& s, const auto& x, const auto& b) { return moved(s, x, b); });
  }
  POLHODE_FLATTEN void contracted_motion(const double* m, const step_noise& w, double* out) const override {
    const auto& s = held();
    each(m, out, [&](const state& x, int lane) -> state {
      if constexpr (matrices)
        return contracted(s, x, noise_at(w, x, lane));
      else
        return absent("sandwich");
    });
  }
  POLHODE_FLATTEN void linearised_contracted_motion([[maybe_unused]] const double* m,
                                                    [[maybe_unused]] const step_noise& w,
                                                    [[maybe_unused]] double* value,
                                                    [[maybe_unused]] double* slope) const override {
    if constexpr (matrices)
      differentiate(m, w, value, slope,
                    [&](const System& s, const auto& x, const auto& b) { return contracted(s, x, b); });
    else
      absent("sandwich");
  }

  POLHODE_FLATTEN void bracket(const double* xi, const double* eta, double* out) const override {
    each(xi, eta, out, [](const state& a, const state& b) { return g::bracket(a, b); });
  }
  POLHODE_FLATTEN void coad(const double* xi, const double* mu, double* out) const override {
    each(xi, mu, out, [](const state& a, const state& b) { return g::coad(a, b); });
  }
  POLHODE_FLATTEN void exp_action(const double* xi, const double* mu, double* out) const override {
    each(xi, mu, out, [](const state& a, const state& b) { return g::exp_action(a, b); });
  }
  POLHODE_FLATTEN void cayley_action(const double* xi, const double* mu, double* out) const override {
    each(xi, mu, out, [](const state& a, const state& b) { return g::cayley_action(a, b); });
  }
  POLHODE_FLATTEN void dexp_inv(const double* u, const double* v, double* out) const override {
    each(u, v, out, [](const state& a, const state& b) -> state {
      if constexpr (requires { g::dexp_inv(a, b); })
        return g::dexp_inv(a, b);
      else
        return absent("dexp_inv");
    });
  }
  POLHODE_FLATTEN void orbit_projection(const double* mu, const double* onto, double* out) const override {
    each(mu, onto, out, [](const state& a, const state& b) { return g::orbit_projection(a, b); });
  }
  POLHODE_FLATTEN void sandwich(const double* xi, const double* mu, double* out) const override {
    each(xi, mu, out, [](const state& a, const state& b) -> state {
      if constexpr (matrices)
        return g::sandwich(a, b);
      else
        return absent("sandwich");
    });
  }

  POLHODE_FLATTEN void free_flow(const double* mu, flow_time t, double* out) const override {
    each(mu, out, [&](const state& x, int) -> state {
      if constexpr (splittable_system<System>)
        return s_.free_flow(x, t.t);
      else
        return absent("free_flow");
    });
  }
  POLHODE_FLATTEN void dissipation_flow(const double* mu, flow_time t, double* out) const override {
    each(mu, out, [&](const state& x, int) -> state { return damped(x, t.t); });
  }
  POLHODE_FLATTEN void first_turn(const double* mu, flow_time t, double* out) const override {
    each(mu, out, [&](const state& x, int) -> state {
      if constexpr (turning_system<System>)
        return s_.first_turn(x, t.t);
      else
        return absent("first_turn");
    });
  }
  POLHODE_FLATTEN void last_turn(const double* mu, flow_time t, double* out) const override {
    each(mu, out, [&](const state& x, int) -> state {
      if constexpr (turning_system<System>)
        return s_.last_turn(x, t.t);
      else
        return absent("last_turn");
    });
  }
  POLHODE_FLATTEN void noise_flow(const double* mu, const step_noise& w, double* out) const override {
    each(mu, out, [&](const state& x, int lane) { return turned(x, w, lane); });
  }
  POLHODE_FLATTEN void damped_noise_flow(const double* mu, const step_noise& w, double* out) const override {
    each(mu, out, [&](const state& x, int lane) { return damped(turned(damped(x, dt_ / 2), w, lane), dt_ / 2); });
  }
  void turned_noise_flow(const double* mu, const step_noise& w, double* out) const override {
    last_turn(mu, {dt_ / 2, 2}, out);
    damped_noise_flow(out, w, out);
    last_turn(out, {dt_ / 2, 2}, out);
  }

 protected:
  /// out = f(mu, lane), a pack of lanes after the other.
  template <class F>
  void each(const double* mu, double* out, F f) const {
    packs([&](int lane) { io::store(f(load(mu + lane), lane), out + lane, K); });
  }
  template <class F>
  void each(const double* a, const double* b, double* out, F f) const {
    each(a, out, [&](const state& x, int lane) { return f(x, load(b + lane)); });
  }
  state load(const double* at) const { return io::template load<N>(at, K, components()); }

  const System& system() const { return s_; }
  /// The system as the loops read it: what is written there might be its constants, were they not a copy.
  decltype(auto) held() const {
    if constexpr (N > 0)
      return System(s_);
    else
      return (s_);
  }

  /// Of one pack: the noise alone, as one exponential.
  state turned(const state& x, const step_noise& w, int lane) const {
    if (w.of == kind::none) return x;
    if constexpr (fixed_noise) {
      if constexpr (under_shared_noise<System>::has_matrix)
        if (w.of == kind::shared) return detail::changed(x, w.rows + 2 * N);
      return g::exp_action(noise_at(w, x, lane), x);
    } else {
      return polhode::noise_flow(s_, x, increment(w, lane));
    }
  }

 private:
  /// f(lane), a pack of lanes after the other. With tangents it is called: they are worth no more of the compiler's
  /// time.
  template <class F>
  static void packs(F f) {
#pragma GCC unroll 1
    for (int lane = 0; lane < K; lane += io::width)
      if constexpr (io::tangents == 0)
        f(lane);
      else
        called(f, lane);
  }
  template <class F>
  [[gnu::noinline]] static void called(const F& f, int lane) {
    f(lane);
  }

  [[noreturn, gnu::cold, gnu::noinline]] static state absent(const char* what) {
    throw std::logic_error(std::string("a scheme asks a system for what it does not have: ") + what);
  }

  state damped(const state& x, double t) const {
    if constexpr (splittable_system<System>)
      return s_.dissipation_flow(x, t);
    else
      return absent("dissipation_flow");
  }

  template <class Number, class Noise>
  vec<Number, N> moved(const System& s, const vec<Number, N>& x, const Noise& noise) const {
    return g::coad(Number(dt_) * s.generator(x) + noise, x);
  }
  template <class Number, class Noise>
  vec<Number, N> contracted(const System& s, const vec<Number, N>& x, const Noise& noise) const {
    const vec<Number, N> xi = Number(dt_) * s.generator(x) + noise;
    return g::coad(xi, x) - Number(0.5) * g::sandwich(xi, x);
  }
  /// value = f(system, mu, noise) and its derivative, by dual numbers.
  template <class F>
  void differentiate([[maybe_unused]] const double* mu, [[maybe_unused]] const step_noise& w,
                     [[maybe_unused]] double* value, [[maybe_unused]] double* slope, [[maybe_unused]] F f) const {
    if constexpr (N > 0 && N <= 6 && io::tangents == 0) {
      using number = dual<S, N>;
      const auto& s = held();
      each(mu, value, [&](const state& at, int lane) {
        const auto x = seeded(at);
        const auto y = f(s, x, noise_at<number>(w, x, lane));
        state out;
        for (int i = 0; i < N; ++i) {
          out[i] = y[i].value;
          io::store(y[i].slope, slope + i * N * K + lane, K);
        }
        return out;
      });
    } else {
      absent("a linearised motion");
    }
  }

  /// sum sigma_i dW^i.
  template <class Number = S>
  vec<Number, N> noise_at(const step_noise& w, const vec<Number, N>& x, int lane) const {
    if (w.of == kind::none) return zeros<vec<Number, N>>(x.size);
    if constexpr (fixed_noise) {
      if (w.of == kind::shared) return detail::lifted<vec<Number, N>>(w.rows, x.size);
      return lane_rows<Number>::template load_values<N>(w.rows + lane, K, x.size);
    } else {
      return polhode::noise(s_, x, increment<Number>(w, lane));
    }
  }
  /// Where the noise vectors depend on the state.
  template <class Number = S>
  wiener<Number, M> increment(const step_noise& w, int lane) const {
    wiener<Number, M> out;
    out.dt = dt_;
    out.dw = zeros<decltype(out.dw)>(channels_of(s_));
    if (w.of == kind::own) out.dw = lane_rows<Number>::template load_values<M>(w.rows + lane, K, channels_of(s_));
    if (w.of == kind::shared) out.dw = detail::lifted<decltype(out.dw)>(w.rows, channels_of(s_));
    return out;
  }

  /// f(noise), noise(mu, lane) the sum of sigma_i dW^i there. Where that is a matter of registers the loop is compiled
  /// for each kind of noise.
  template <class F>
  void with_noise(const step_noise& w, F f) const {
    if constexpr (!fixed_noise || io::tangents > 0 || N < 0) {
      f([&](const state& x, int lane) { return noise_at(w, x, lane); });
    } else {
      switch (w.of) {
        case kind::none: return f([](const state&, int) { return zero_vector{}; });
        case kind::own:
          return f([rows = w.rows](const state& x, int lane) {
            return io::template load_values<N>(rows + lane, K, x.size);
          });
        case kind::shared: return f([b = detail::lifted<state>(w.rows, components())](const state&, int) { return b; });
      }
    }
  }

  System s_;
  double dt_;
};

}  // namespace polhode
