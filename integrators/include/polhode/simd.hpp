// The pack type: as many doubles as one register of the target holds. The only file with intrinsics, each beside its
// portable twin.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <experimental/simd>
#include <utility>

#if defined(__AVX2__) || defined(__SSE2__)
#include <immintrin.h>
#endif

namespace polhode {

namespace stdx = std::experimental;

using pack = stdx::native_simd<double>;

template <class S>
inline constexpr bool is_pack = stdx::is_simd_v<S>;

/// f(0), ..., f(N-1) written out, so that arrays of packs stay in registers.
template <std::size_t N, class F>
void unrolled(const F& f) {
  [&]<std::size_t... I>(std::index_sequence<I...>) { (f(I), ...); }
  (std::make_index_sequence<N>());
}

/// The bits of a scalar: 64 per lane.
template <class S>
struct bits_of_scalar {
  using type = stdx::rebind_simd_t<std::uint64_t, S>;
};
template <>
struct bits_of_scalar<double> {
  using type = std::uint64_t;
};
template <class S>
using bits_of = typename bits_of_scalar<S>::type;

/// Low and high half of 128 bits.
using aes_block = std::array<std::uint64_t, 2>;

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

/// Multiplication by x in GF(2^8) modulo x^8 + x^4 + x^3 + x + 1.
constexpr std::uint8_t times_x(std::uint8_t a) { return static_cast<std::uint8_t>(a << 1 ^ (a >> 7) * 0x1B); }

/// The inverse in GF(2^8), then the affine map of FIPS 197, section 5.1.1. p runs through the powers of the generator
/// 3, q through their inverses.
constexpr std::array<std::uint8_t, 256> make_s_box() {
  std::array<std::uint8_t, 256> box{};
  box[0] = 0x63;
  std::uint8_t p = 1, q = 1;
  do {
    p = static_cast<std::uint8_t>(p ^ times_x(p));
    for (const int shift : {1, 2, 4}) q = static_cast<std::uint8_t>(q ^ q << shift);
    if (q & 0x80) q ^= 0x09;
    int sum = q;
    for (int turn = 1; turn < 5; ++turn) sum ^= q << turn | q >> (8 - turn);
    box[p] = static_cast<std::uint8_t>(sum ^ 0x63);
  } while (p != 1);
  return box;
}
inline constexpr std::array<std::uint8_t, 256> s_box = make_s_box();

template <bool Last>
constexpr aes_block aes_round(const aes_block& x, const aes_block& key) {
  auto out = key;
  for (unsigned column = 0; column < 4; ++column) {
    std::array<std::uint8_t, 4> s{};
    for (unsigned row = 0; row < 4; ++row) {
      const unsigned from = 4 * ((column + row) % 4) + row;  // ShiftRows
      s[row] = s_box[x[from / 8] >> 8 * (from % 8) & 0xFF];
    }
    for (unsigned row = 0; row < 4; ++row) {
      const std::uint8_t a = s[row], b = s[(row + 1) % 4];
      const int mixed = times_x(static_cast<std::uint8_t>(a ^ b)) ^ b ^ s[(row + 2) % 4] ^ s[(row + 3) % 4];
      out[column / 2] ^= static_cast<std::uint64_t>(Last ? a : mixed) << (32 * (column % 2) + 8 * row);
    }
  }
  return out;
}
template <std::size_t N>
constexpr aes_block aes(const aes_block& x, const std::array<aes_block, N>& keys) {
  aes_block s{x[0] ^ keys[0][0], x[1] ^ keys[0][1]};
  for (std::size_t i = 1; i + 1 < N; ++i) s = aes_round<false>(s, keys[i]);
  return aes_round<true>(s, keys[N - 1]);
}
template <class B, std::size_t N>
requires is_pack<B> B aes(const B& x, const std::array<B, N>& keys) {
  std::array<aes_block, N> same;
  for (std::size_t i = 0; i < N; ++i) same[i] = {keys[i][0], keys[i][1]};
  return B([&](std::size_t i) { return aes(aes_block{x[i - i % 2], x[i - i % 2 + 1]}, same)[i % 2]; });
}

template <class F, class U>
F lookup(const std::array<float, 16>& table, const U& index) {
  if constexpr (is_pack<F>)
    return F([&](std::size_t i) { return table[index[i] & 15]; });
  else
    return table[index & 15];
}

template <class F>
void store_scaled(const F& x, double scale, double* out) {
  for (std::size_t i = 0; i < F::size(); ++i) out[i] = scale * double{x[i]};
}

}  // namespace twin

/// The full products of the low 32 bits of every 64-bit lane.
inline std::uint64_t multiply_low_words(std::uint64_t a, std::uint64_t b) {
  return (a & 0xFFFFFFFF) * (b & 0xFFFFFFFF);
}
template <class B>
requires is_pack<B> B multiply_low_words(const B& a, const B& b) {
#if defined(__AVX512F__)
  if constexpr (sizeof(B) == 64)
    return B(static_cast<__m512i>(_mm512_mul_epu32(static_cast<__m512i>(a), static_cast<__m512i>(b))));
#endif
#if defined(__AVX2__)
  if constexpr (sizeof(B) == 32)
    return B(static_cast<__m256i>(_mm256_mul_epu32(static_cast<__m256i>(a), static_cast<__m256i>(b))));
#endif
#if defined(__SSE2__)
  if constexpr (sizeof(B) == 16)
    return B(static_cast<__m128i>(_mm_mul_epu32(static_cast<__m128i>(a), static_cast<__m128i>(b))));
#endif
  const B word(0xFFFFFFFF);
  return (a & word) * (b & word);
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

/// AES with given round keys on every 128-bit block of a pack (low half in the even lanes, high half in the odd): key 0
/// is added; then rounds of S-box, ShiftRows, MixColumns except in the last, and key (FIPS 197). Every block has the
/// same keys.
template <class B, std::size_t N>
B aes(const B& x, const std::array<B, N>& keys) {
#if defined(__VAES__) && defined(__AVX512F__)
  if constexpr (sizeof(B) == 64) {
    const auto key = [&](std::size_t i) { return static_cast<__m512i>(keys[i]); };
    auto s = _mm512_xor_si512(static_cast<__m512i>(x), key(0));
    for (std::size_t i = 1; i + 1 < N; ++i) s = _mm512_aesenc_epi128(s, key(i));
    return B(_mm512_aesenclast_epi128(s, key(N - 1)));
  }
#endif
#if defined(__AES__) && defined(__AVX2__)
  if constexpr (sizeof(B) == 32) {
    const auto key = [&](std::size_t i) { return _mm256_castsi256_si128(static_cast<__m256i>(keys[i])); };
    const auto s = static_cast<__m256i>(x);
    auto low = _mm_xor_si128(_mm256_castsi256_si128(s), key(0));
    auto high = _mm_xor_si128(_mm256_extracti128_si256(s, 1), key(0));
    for (std::size_t i = 1; i + 1 < N; ++i) low = _mm_aesenc_si128(low, key(i)), high = _mm_aesenc_si128(high, key(i));
    return B(_mm256_set_m128i(_mm_aesenclast_si128(high, key(N - 1)), _mm_aesenclast_si128(low, key(N - 1))));
  }
#endif
#if defined(__AES__)
  if constexpr (sizeof(B) == 16) {
    const auto key = [&](std::size_t i) { return static_cast<__m128i>(keys[i]); };
    auto s = _mm_xor_si128(static_cast<__m128i>(x), key(0));
    for (std::size_t i = 1; i + 1 < N; ++i) s = _mm_aesenc_si128(s, key(i));
    return B(_mm_aesenclast_si128(s, key(N - 1)));
  }
#endif
  return twin::aes(x, keys);
}

/// The float nearest to an integer below 2^31.
inline float to_float(std::uint32_t a) { return static_cast<float>(static_cast<std::int32_t>(a)); }
template <class U>
requires is_pack<U>
auto to_float(const U& a) {
  return stdx::static_simd_cast<stdx::rebind_simd_t<float, U>>(
      stdx::static_simd_cast<stdx::rebind_simd_t<std::int32_t, U>>(a));
}

/// table[index mod 16] in every lane.
template <class F, class U>
F lookup(const std::array<float, 16>& table, const U& index) {
#if defined(__AVX512F__)
  if constexpr (sizeof(F) == 64)
    return F(_mm512_permutexvar_ps(static_cast<__m512i>(index), _mm512_loadu_ps(table.data())));
#endif
#if defined(__AVX2__)
  if constexpr (sizeof(F) == 32) {
    const auto i = static_cast<__m256i>(index);
    return F(_mm256_blendv_ps(_mm256_permutevar8x32_ps(_mm256_loadu_ps(table.data()), i),
                              _mm256_permutevar8x32_ps(_mm256_loadu_ps(table.data() + 8), i),
                              _mm256_castsi256_ps(_mm256_slli_epi32(i, 28))));
  }
#endif
  return twin::lookup<F>(table, index);
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
