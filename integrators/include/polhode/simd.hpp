// SPDX-License-Identifier: Apache-2.0
// The pack type: as many doubles as one register of the target holds. The only file with intrinsics, each beside its
// portable twin; over 200 lines, as that pairing is what keeps them equal.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <experimental/simd>
#include <type_traits>

#if defined(__AVX2__) || defined(__SSE2__)
#include <immintrin.h>
#endif

#include <polhode/scalar.hpp>
#include <polhode/words.hpp>

namespace polhode {

namespace stdx = std::experimental;

using pack = stdx::native_simd<double>;

template <class T, class Abi>
inline constexpr bool is_pack<stdx::simd<T, Abi>> = true;

/// What the intrinsics below do, in plain C++: the same bits.
namespace twin {

template <class B>
std::array<B, 2> interleave(const B& a, const B& b) {
  if constexpr (!is_pack<B>) {
    return {a, b};
  } else if constexpr (B::size() % 2 == 1) {
    return {a, b};
  } else {
    return {B([&](std::size_t i) { return i % 2 == 0 ? a[i] : b[i - 1]; }),
            B([&](std::size_t i) { return i % 2 == 0 ? a[i + 1] : b[i]; })};
  }
}

template <class F, class U, std::size_t N>
F lookup(const std::array<float, N>& table, const U& index) {
  return F([&](std::size_t i) { return table[index[i] % N]; });
}

template <class F>
void store_scaled(const F& x, double scale, double* out) {
  for (std::size_t i = 0; i < F::size(); ++i) out[i] = scale * double{x[i]};
}

}  // namespace twin

/// What scalar.hpp and words.hpp say of one number, for a pack P of them.
template <class P>
struct of_packs {
  using bits = stdx::rebind_simd_t<std::uint64_t, P>;
  using mask = typename P::mask_type;

  static P select(const mask& condition, const P& yes, P no) {
#if defined(__clang__) && defined(__AVX512F__)
    // There the masked assignment of libstdc++ 12 takes the wrong lanes.
    return P([&](auto i) { return condition[i] ? yes[i] : no[i]; });
#else
    stdx::where(condition, no) = yes;
    return no;
#endif
  }
  static bool any(const mask& m) { return stdx::any_of(m); }
  static P square_root(const P& x) { return stdx::sqrt(x); }
  static P magnitude(const P& x) { return stdx::abs(x); }

  static P multiply_low_words(const P& a, const P& b) {
#if defined(__AVX512F__)
    if constexpr (sizeof(P) == 64)
      return P(static_cast<__m512i>(_mm512_mul_epu32(static_cast<__m512i>(a), static_cast<__m512i>(b))));
#endif
#if defined(__AVX2__)
    if constexpr (sizeof(P) == 32)
      return P(static_cast<__m256i>(_mm256_mul_epu32(static_cast<__m256i>(a), static_cast<__m256i>(b))));
#endif
#if defined(__SSE2__)
    if constexpr (sizeof(P) == 16)
      return P(static_cast<__m128i>(_mm_mul_epu32(static_cast<__m128i>(a), static_cast<__m128i>(b))));
#endif
    const P word(0xFFFFFFFF);
    return (a & word) * (b & word);
  }
  static P join_low_words(const P& a, const P& b) {
#if defined(__AVX512F__)
    if constexpr (sizeof(P) == 64)
      return P(_mm512_mask_shuffle_epi32(static_cast<__m512i>(a), 0xAAAA, static_cast<__m512i>(b), _MM_PERM_CCAA));
#endif
#if defined(__AVX2__)
    if constexpr (sizeof(P) == 32)
      return P(_mm256_blend_epi32(static_cast<__m256i>(a), static_cast<__m256i>(b << 32), 0xAA));
#endif
    return (a & P(0xFFFFFFFF)) | b << 32;
  }

  static auto cut_to_float(const P& a) {
    using F = stdx::rebind_simd_t<float, P>;
#if defined(__AVX512F__)
    if constexpr (sizeof(P) == 64)
      return F(_mm512_cvt_roundepi32_ps(static_cast<__m512i>(a), _MM_FROUND_TO_ZERO | _MM_FROUND_NO_EXC));
    else
#endif
    {
      const P cut = a & ~(a >> 24);  // as of one number
      return stdx::static_simd_cast<F>(stdx::static_simd_cast<stdx::rebind_simd_t<std::int32_t, P>>(cut));
    }
  }
  static P fused(const P& a, const P& b, const P& c) {
#if defined(__AVX512F__)
    if constexpr (sizeof(P) == 64)
      return P(_mm512_fmadd_ps(static_cast<__m512>(a), static_cast<__m512>(b), static_cast<__m512>(c)));
#endif
#if defined(__FMA__)
    if constexpr (sizeof(P) == 32)
      return P(_mm256_fmadd_ps(static_cast<__m256>(a), static_cast<__m256>(b), static_cast<__m256>(c)));
    if constexpr (sizeof(P) == 16)
      return P(_mm_fmadd_ps(static_cast<__m128>(a), static_cast<__m128>(b), static_cast<__m128>(c)));
#endif
    return P([&](std::size_t i) { return polhode::fused<float>(a[i], b[i], c[i]); });
  }
  template <class U, std::size_t N>
  static P lookup(const std::array<float, N>& table, const U& index) {
#if defined(__AVX512F__)
    if constexpr (sizeof(P) == 64 && N == 16)
      return P(_mm512_permutexvar_ps(static_cast<__m512i>(index), _mm512_loadu_ps(table.data())));
#endif
#if defined(__AVX2__)
    if constexpr (sizeof(P) == 32) {
      const auto i = static_cast<__m256i>(index);
      if constexpr (N == 8) return P(_mm256_permutevar8x32_ps(_mm256_loadu_ps(table.data()), i));
      return P(_mm256_blendv_ps(_mm256_permutevar8x32_ps(_mm256_loadu_ps(table.data()), i),
                                _mm256_permutevar8x32_ps(_mm256_loadu_ps(table.data() + 8), i),
                                _mm256_castsi256_ps(_mm256_slli_epi32(i, 28))));
    }
#endif
    return twin::lookup<P>(table, index);
  }
  /// Whether every lane of all is at least so much.
  template <std::size_t N>
  static bool reach(const std::array<P, N>& all, const P& least) {
    P lowest = all[0];
    for (std::size_t i = 1; i < N; ++i) lowest = stdx::min(lowest, all[i]);
    return stdx::all_of(lowest >= least);
  }
};

/// A product that several sums share. Without this the compiler fuses it into each of them, and so computes it as
/// often.
template <class S>
S rounded_product(const S& x) {
#if defined(__has_builtin)
#if __has_builtin(__builtin_assoc_barrier)
  if constexpr (std::is_same_v<S, double>) {
    return __builtin_assoc_barrier(x);
  } else if constexpr (is_pack<S>) {
    if constexpr (S::size() == pack::size()) {
      using bare [[gnu::vector_size(sizeof(pack))]] = double;
      return S(std::bit_cast<pack>(__builtin_assoc_barrier(std::bit_cast<bare>(pack(x)))));
    } else if constexpr (S::size() == 2 * pack::size()) {
      const auto halves = stdx::split<pack>(x);
      return S(stdx::concat(rounded_product(halves[0]), rounded_product(halves[1])));
    }
  }
#endif
#endif
  return x;
}

/// (A0 A1 A2 A3 …), (B0 B1 B2 B3 …) to (A0 B0 A2 B2 …), (A1 B1 A3 B3 …): two packs of low and of high halves become two
/// packs of 128-bit blocks. It is its own inverse; a pack of odd size, and a scalar, stays as it is.
template <class B>
std::array<B, 2> interleave(const B& a, const B& b) {
#if defined(__AVX512F__)
  if constexpr (sizeof(B) == 64) {
    const auto x = static_cast<__m512i>(a), y = static_cast<__m512i>(b);
    return {B(_mm512_unpacklo_epi64(x, y)), B(_mm512_unpackhi_epi64(x, y))};
  }
#endif
#if defined(__AVX2__)
  if constexpr (sizeof(B) == 32) {
    const auto x = static_cast<__m256i>(a), y = static_cast<__m256i>(b);
    return {B(_mm256_unpacklo_epi64(x, y)), B(_mm256_unpackhi_epi64(x, y))};
  }
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(B) == 16) {
    const auto x = static_cast<__m128i>(a), y = static_cast<__m128i>(b);
    return {B(_mm_unpacklo_epi64(x, y)), B(_mm_unpackhi_epi64(x, y))};
  }
#endif
  return twin::interleave(a, b);
}

/// Has the target AES instructions for packs of this size?
template <class B>
inline constexpr bool has_aes =
#if defined(__VAES__) && defined(__AVX512F__)
    sizeof(B) == 64 ||
#endif
#if defined(__AES__) && defined(__AVX2__)
    sizeof(B) == 32 ||
#endif
#if defined(__AES__)
    sizeof(B) == 16 ||
#endif
    false;

/// One round of AES on every 128-bit block of a pack (low half in the even lanes, high half in the odd): S-box,
/// ShiftRows, MixColumns except in the last, and key, which is the same for every block (FIPS 197).
template <bool Last, class B>
requires has_aes<B> B aes_round([[maybe_unused]] const B& x, [[maybe_unused]] const B& key) {
#if defined(__VAES__) && defined(__AVX512F__)
  if constexpr (sizeof(B) == 64) {
    const auto s = static_cast<__m512i>(x), k = static_cast<__m512i>(key);
    return B(Last ? _mm512_aesenclast_epi128(s, k) : _mm512_aesenc_epi128(s, k));
  }
#endif
#if defined(__AES__)
  if constexpr (sizeof(B) == 16) {
    const auto s = static_cast<__m128i>(x), k = static_cast<__m128i>(key);
    return B(Last ? _mm_aesenclast_si128(s, k) : _mm_aesenc_si128(s, k));
  }
#endif
}

/// Two blocks as one pack, low first. (The library's concat goes through memory, and the load waits for both stores.)
template <class B, class Block>
B join_blocks(const Block& low, const Block& high) {
#if defined(__AVX2__)
  if constexpr (sizeof(B) == 32) return B(_mm256_set_m128i(static_cast<__m128i>(high), static_cast<__m128i>(low)));
#endif
  return B(stdx::concat(low, high));
}

/// AES with given round keys: key 0 is added, then the rounds. Several packs advance round by round, since each is one
/// long chain of operations that wait for each other.
template <class B, std::size_t N, std::size_t Keys>
requires has_aes<B> std::array<B, N> aes(const std::array<B, N>& blocks, const std::array<B, Keys>& keys) {
  std::array<B, N> x;
  if constexpr (sizeof(B) == 32) {  // instructions take one block or four: two are taken apart once, not each round
    using block = stdx::resize_simd_t<2, B>;
    std::array<block, 2 * N> halves;
    std::array<block, Keys> block_keys;
    unrolled<N>([&](std::size_t i) {
      const auto half = stdx::split<block>(blocks[i]);
      halves[2 * i] = half[0], halves[2 * i + 1] = half[1];
    });
    unrolled<Keys>([&](std::size_t i) { block_keys[i] = stdx::split<block>(keys[i])[0]; });
    halves = aes(halves, block_keys);
    unrolled<N>([&](std::size_t i) { x[i] = join_blocks<B>(halves[2 * i], halves[2 * i + 1]); });
  } else {
    unrolled<N>([&](std::size_t i) { x[i] = blocks[i] ^ keys[0]; });
    unrolled<Keys - 2>([&](std::size_t round) {
      unrolled<N>([&](std::size_t i) { x[i] = aes_round<false>(x[i], keys[round + 1]); });
    });
    unrolled<N>([&](std::size_t i) { x[i] = aes_round<true>(x[i], keys[Keys - 1]); });
  }
  return x;
}

/// out[i] = scale x[i], in double precision.
template <class F>
void store_scaled(const F& x, double scale, double* out) {
#if defined(__AVX512DQ__)
  if constexpr (sizeof(F) == 64) {
    const auto v = static_cast<__m512>(x);
    const auto low = _mm512_cvtps_pd(_mm512_castps512_ps256(v));
    const auto high = _mm512_cvtps_pd(_mm512_extractf32x8_ps(v, 1));
    _mm512_storeu_pd(out, _mm512_mul_pd(low, _mm512_set1_pd(scale)));
    _mm512_storeu_pd(out + 8, _mm512_mul_pd(high, _mm512_set1_pd(scale)));
    return;
  }
#endif
#if defined(__AVX2__)
  if constexpr (sizeof(F) == 32) {
    const auto v = static_cast<__m256>(x);
    const auto low = _mm256_cvtps_pd(_mm256_castps256_ps128(v)), high = _mm256_cvtps_pd(_mm256_extractf128_ps(v, 1));
    _mm256_storeu_pd(out, _mm256_mul_pd(low, _mm256_set1_pd(scale)));
    _mm256_storeu_pd(out + 4, _mm256_mul_pd(high, _mm256_set1_pd(scale)));
    return;
  }
#endif
  twin::store_scaled(x, scale, out);
}

}  // namespace polhode
