// SPDX-License-Identifier: Apache-2.0
// What random bits are made with, on one word or on packs of them: the same bits. Of packs polhode/simd.hpp knows.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include <polhode/scalar.hpp>

namespace polhode {

/// f(0), ..., f(N-1) written out, so that arrays of packs stay in registers.
template <std::size_t N, class F>
void unrolled(const F& f) {
  [&]<std::size_t... I>(std::index_sequence<I...>) { (f(I), ...); }
  (std::make_index_sequence<N>());
}

/// The full products of the low 32 bits of every 64-bit lane.
template <class B>
B multiply_low_words(const B& a, const B& b) {
  if constexpr (is_pack<B>)
    return of_packs<B>::multiply_low_words(a, b);
  else
    return (a & 0xFFFFFFFF) * (b & 0xFFFFFFFF);
}

/// a's low word below b's low word in every 64-bit lane.
template <class B>
B join_low_words(const B& a, const B& b) {
  if constexpr (is_pack<B>)
    return of_packs<B>::join_low_words(a, b);
  else
    return (a & 0xFFFFFFFF) | b << 32;
}

/// The integer below 2^31 as a float, cut to its 24 leading bits.
template <class U>
auto cut_to_float(const U& a) {
  if constexpr (is_pack<U>)
    return of_packs<U>::cut_to_float(a);
  else  // without the first bit that a float drops nothing is rounded up
    return static_cast<float>(static_cast<std::int32_t>(a & ~(a >> 24)));
}

/// a b + c, rounded once. Where the target has no such instruction it is the standard library's, lane by lane: slow,
/// with the same bits.
template <class F>
F fused(const F& a, const F& b, const F& c) {
  if constexpr (is_pack<F>)
    return of_packs<F>::fused(a, b, c);
  else
    return std::fma(a, b, c);
}

/// table[index mod N] in every lane, N = 16 or 8.
template <class F, class U, std::size_t N>
F lookup(const std::array<float, N>& table, const U& index) {
  if constexpr (is_pack<F>)
    return of_packs<F>::lookup(table, index);
  else
    return table[index % N];
}

}  // namespace polhode
