// SPDX-License-Identifier: Apache-2.0
// What a step may ask of its noise. The type of a scheme's increment parameter is the statement of what it needs:
// wiener < wiener_levy < with_variables<…>; what is not asked for is never drawn.
#pragma once

#include <polhode/vec.hpp>

namespace polhode {

/// Number of pairs i < j among so many channels, ordered (0,1), (0,2), …, (1,2), …
constexpr int pairs_among(int channels) { return channels * (channels - 1) / 2; }
/// Of a vec<S, M>: at most so many where M < 0.
template <int M>
inline constexpr int pairs_of = M < 0 ? -pairs_among(-M) : pairs_among(M);

/// A step, or one of its equal parts: a time that converts to double, and a type on which a system bound to its step
/// size can look up what it has computed in advance.
template <int parts>
struct part_of_step {
  double dt = 0;
  constexpr operator double() const { return dt / parts; }
};
using whole_step = part_of_step<1>;
using half_step = part_of_step<2>;

/// The type of times beside numbers of type S: double; a scalar that expands in dt has one of its own.
template <class S>
struct time_beside {
  using type = double;
};
template <class S>
using time_of = typename time_beside<S>::type;

/// dt, the increments W(t + dt) - W(t) of M independent Wiener processes, and the time t at which the step begins.
template <class S, int M>
struct wiener {
  time_of<S> dt{};
  vec<S, M> dw{};
  time_of<S> t{};
};

/// The same with the Levy areas A^ij = 1/2 (int W^i dW^j - int W^j dW^i), i < j, of this step alone.
template <class S, int M>
struct wiener_levy : wiener<S, M> {
  vec<S, pairs_of<M>> area{};
};

/// An increment with further random variables of the step. Each is a struct with members of names of its own:
///   template <class S, int M> struct space_time_areas { vec<S, M> space_time; };
///   step(const System&, const vec<S, N>& mu, const with_variables<wiener<S, M>, space_time_areas<S, M>>& w)
/// It converts to the increment, so whatever asks for less takes it as it is.
template <class Increment, class... Variables>
struct with_variables : Increment, Variables... {};

/// Chen's relation: the increment over two adjacent steps, first then second.
///   W = W1 + W2,   A^ij = A1^ij + A2^ij + 1/2 (W1^i W2^j - W1^j W2^i)
/// Source: K.-T. Chen, Ann. of Math. 65 (1957) 163-178; as here in Friz, Hairer, A Course on Rough Paths, eq. (2.1).
template <class S, int M>
wiener_levy<S, M> chen(const wiener_levy<S, M>& first, const wiener_levy<S, M>& second) {
  wiener_levy<S, M> both;
  both.dt = first.dt + second.dt;
  both.dw = first.dw + second.dw;
  both.t = first.t;
  both.area = first.area;
  int pair = 0;
  for (int i = 0; i < both.dw.size; ++i)
    for (int j = i + 1; j < both.dw.size; ++j, ++pair)
      both.area[pair] =
          first.area[pair] + second.area[pair] + S(0.5) * (first.dw[i] * second.dw[j] - first.dw[j] * second.dw[i]);
  return both;
}

}  // namespace polhode
