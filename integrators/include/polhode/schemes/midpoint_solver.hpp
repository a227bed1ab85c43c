// SPDX-License-Identifier: Apache-2.0
// The stage of midpoint rules: m = mu + 1/2 f(m), solved by Newton's method.
//
// Rule::motion(system, m, w) is f, Rule::linearised_motion(system, m, w) f with its derivative. Newton on F(m) = m - mu
// - 1/2 f(m). The noise is linear in m, so that F'' is of the order of dt, and the derivative at mu serves all
// corrections of a step of ordinary size: each is smaller than the one before by about dt |m - mu|. Where they do not
// get small Newton's method starts again. A fixed-point iteration would diverge for the larger Gaussian increments. A
// step whose iteration does not converge returns NaN in its lane: failure is data.
#pragma once

#include <concepts>
#include <limits>
#include <utility>

#include <polhode/dual.hpp>
#include <polhode/schemes/scheme_info.hpp>
#include <polhode/solve.hpp>

namespace polhode {

/// (1 - slope / 2)^-1: DF(m)^-1 of F(m) = m - mu - motion(m) / 2.
template <quotient q, class S, int n>
matrix<S, n> inverse_derivative(const linearised<S, n>& motion_at) {
  auto out = zeros<matrix<S, n>>(motion_at.value.size);
  for (int k = 0; k < out.size; ++k) {
    out[k] = S(-0.5) * motion_at.slope[k];
    out[k][k] = S(1.0) + out[k][k];
  }
  return inverse<q>(out);
}

/// Takes c = back residual from way. Returns c.c.
template <class S, int n>
S correct(vec<S, n>& way, const matrix<S, n>& back, const vec<S, n>& residual) {
  const auto c = times(back, residual);
  way = way - c;
  return dot(c, c);
}

template <class Rule>
struct midpoint_solver {
  static constexpr int most_corrections = 8;   ///< by the derivative at mu
  static constexpr int most_repetitions = 40;  ///< where there is no derivative
  static constexpr int max_iterations = 16;    ///< of Newton's method, where these do not do
  static constexpr double tolerance = 1e-16;   ///< of the error left, relative to the state
  static constexpr double rounding = 1e-15;    ///< a correction below it is none

  /// Ad*_Cay(xi(m)) mu, so that the Casimirs do not depend on the last digits of m.
  template <lie_poisson_system System, class S>
  static auto cayley_step(const System& system, const vec<S, System::dimension>& mu,
                          const wiener<S, System::channels>& w) {
    const auto solved = midpoint(system, mu, w);
    const auto next = System::algebra::cayley_action(generator(system, solved.m, w), mu);
    return select(solved.failed, S(std::numeric_limits<double>::quiet_NaN()) * next, next);
  }

 private:
  template <class Vector, class Mask>
  struct solution {
    Vector m;
    Mask failed;
  };

  template <class System, class S>
  requires(System::dimension > 0) static auto midpoint(const System& system, const vec<S, System::dimension>& mu,
                                                       const wiener<S, System::channels>& w) {
    const auto at = Rule::linearised_motion(system, mu, w);
    const auto back = inverse_derivative<quotient::truncated>(at);
    const S size = dot(mu, mu);
    auto way = times(back, S(0.5) * at.value);  // m - mu
    const auto residual = [&] { return way - S(0.5) * Rule::motion(system, mu + way, w); };
    // What is left is about the last correction times its ratio to the one before, which where corrections run away to
    // infinity is none.
    const auto done = [&](const S& last, const S& before) {
      const S least = select(before < size, before, size);
      return last <= S(rounding * rounding) * size || last * last <= S(tolerance * tolerance) * least * size;
    };
    S before = size, last = size;
    for (int i = 0; i < usual_corrections<System, S>; ++i) {
      before = last;
      last = correct(way, back, residual());
    }
    auto pending = !done(last, before);
    for (int i = usual_corrections<System, S>; i < most_corrections && any(S(0.0), pending); ++i) {
      const auto c = times(back, residual());
      way = select(pending, way - c, way);
      before = last;
      last = dot(c, c);
      pending = pending && !done(last, before);
    }
    auto m = mu + way;
    if (any(S(0.0), pending)) [[unlikely]]
      iterate(system, mu, w, m, pending);
    return solution<decltype(m), decltype(pending)>{m, pending};
  }

  /// Of duals the values are solved for alone, then the slopes.
  template <class System, class V, int slopes>
  requires(System::dimension > 0) static auto midpoint(const System& system,
                                                       const vec<dual<V, slopes>, System::dimension>& mu,
                                                       const wiener<dual<V, slopes>, System::channels>& w) {
    const auto solved = midpoint(system, values_of(mu), values_of(w));
    const auto m = with_slopes(system, mu, solved.m, w);
    return solution<std::remove_const_t<decltype(m)>, decltype(solved.failed)>{m, solved.failed};
  }

  /// Where the number of components is not known to the compiler: m = mu + motion(m) / 2 repeated, as no matrix pays;
  /// Newton's method for the lanes where that is too slow.
  template <class System, class S>
  requires(System::dimension < 0) static auto midpoint(const System& system, const vec<S, System::dimension>& mu,
                                                       const wiener<S, System::channels>& w) {
    const S size = dot(mu, mu);
    auto m = mu;
    auto pending = size >= S(0.0);  // not where it is no number
    for (int i = 0; i < most_repetitions && any(S(0.0), pending); ++i) {
      const auto next = mu + S(0.5) * Rule::motion(system, m, w);
      const auto change = next - m;
      m = select(pending, next, m);
      pending = pending && !(dot(change, change) <= S(rounding * rounding) * size);
    }
    if (any(S(0.0), pending)) [[unlikely]]
      iterate(system, mu, w, m, pending);
    return solution<decltype(m), decltype(pending)>{m, pending};
  }
  /// The same of duals: values first, then slopes, which settle at the same rate or not at all.
  template <class System, class V, int slopes>
  requires(System::dimension < 0) static auto midpoint(const System& system,
                                                       const vec<dual<V, slopes>, System::dimension>& mu,
                                                       const wiener<dual<V, slopes>, System::channels>& w) {
    using number = dual<V, slopes>;
    const auto solved = midpoint(system, values_of(mu), values_of(w));
    auto m = mu;
    for (int k = 0; k < m.size; ++k) m[k].value = solved.m[k];
    const auto take = [&](const auto& lanes, const auto& from) {
      for (int k = 0; k < m.size; ++k)
        for (int t = 0; t < slopes; ++t) m[k].slope[t] = select(lanes, from[k].slope[t], m[k].slope[t]);
    };
    auto pending = !solved.failed;
    for (int i = 0; i < most_repetitions && any(V(0.0), pending); ++i) {
      const auto next = mu + number(0.5) * Rule::motion(system, m, w);
      const auto open = pending && !slopes_settled(m, next);
      take(pending, next);
      pending = open;
    }
    if (any(V(0.0), pending)) [[unlikely]]
      take(pending, with_slopes(system, mu, solved.m, w));
    return solution<decltype(m), decltype(solved.failed)>{m, solved.failed};
  }

  template <class V, int slopes, int N>
  static auto values_of(const vec<dual<V, slopes>, N>& of) {
    auto out = zeros<vec<V, N>>(of.size);
    for (int k = 0; k < of.size; ++k) out[k] = of[k].value;
    return out;
  }
  template <class V, int slopes, int M>
  static auto values_of(const wiener<dual<V, slopes>, M>& w) {
    return wiener<V, M>{w.dt, values_of(w.dw)};
  }

  /// m with the slopes that F(m, mu, dW) = 0 gives: DF dm = -dF at constant m.
  template <class System, class V, int slopes, int N>
  static auto with_slopes(const System& system, const vec<dual<V, slopes>, N>& mu, const vec<V, N>& solved,
                          const wiener<dual<V, slopes>, System::channels>& w) {
    using number = dual<V, slopes>;
    const auto back = inverse_derivative<quotient::exact>(Rule::linearised_motion(system, solved, values_of(w)));
    auto m = zeros<vec<number, N>>(mu.size);
    for (int k = 0; k < m.size; ++k) m[k].value = solved[k];
    const auto f = m - mu - number(0.5) * Rule::motion(system, m, w);
    for (int t = 0; t < slopes; ++t) {
      auto moved = solved;
      for (int k = 0; k < moved.size; ++k) moved[k] = f[k].slope[t];
      const auto way = times(back, moved);
      for (int k = 0; k < m.size; ++k) m[k].slope[t] = -way[k];
    }
    return m;
  }

  /// Whether no direction has changed by more than rounding.
  template <class V, int slopes, int N>
  static auto slopes_settled(const vec<dual<V, slopes>, N>& before, const vec<dual<V, slopes>, N>& now) {
    vec<V, slopes> change{}, size{};
    for (int k = 0; k < now.size; ++k)
      for (int t = 0; t < slopes; ++t) {
        const V moved = now[k].slope[t] - before[k].slope[t];
        change[t] = change[t] + moved * moved;
        size[t] = size[t] + now[k].slope[t] * now[k].slope[t];
      }
    auto settled = change[0] <= V(rounding * rounding) * size[0];
    for (int t = 1; t < slopes; ++t) settled = settled && change[t] <= V(rounding * rounding) * size[t];
    return settled;
  }

  /// Without a question in between: a branch that packs take or do not would cost more than one too many.
  template <class System, class S>
  static constexpr int usual_corrections =
      std::same_as<decltype(noise(std::declval<const System&>(), state_of<System, S>{}, wiener<S, System::channels>{})),
                   zero_vector>
          ? 2
          : 3;

  /// DF(m)^-1 F(m).
  template <class System, class S>
  static auto newton_correction(const System& system, const vec<S, System::dimension>& mu,
                                const vec<S, System::dimension>& m, const wiener<S, System::channels>& w) {
    const auto at = Rule::linearised_motion(system, m, w);
    return times(inverse_derivative<quotient::exact>(at), m - mu - S(0.5) * at.value);
  }

  /// Newton's method from mu, in the pending lanes; those where it fails stay pending.
  template <class System, class S, class Mask>
  [[gnu::cold, gnu::noinline]] static void iterate(const System& system, const vec<S, System::dimension>& mu,
                                                   const wiener<S, System::channels>& w, vec<S, System::dimension>& m,
                                                   Mask& pending) {
    m = select(pending, mu, m);
    for (int i = 0; i < max_iterations && any(S(0.0), pending); ++i) {
      const auto correction = newton_correction(system, mu, m, w);
      m = select(pending, m - correction, m);
      pending = pending && !(dot(correction, correction) <= S(100 * rounding * rounding) * dot(mu, mu));
    }
  }
};

}  // namespace polhode
