// The pack type: as many doubles as one register of the target holds. The only file with intrinsics, each beside its
// portable twin.
#pragma once

#include <cstdint>
#include <experimental/simd>

#if defined(__AVX2__) || defined(__SSE2__)
#include <immintrin.h>
#endif

namespace polhode {

namespace stdx = std::experimental;

using pack = stdx::native_simd<double>;

template <class S>
inline constexpr bool is_pack = stdx::is_simd_v<S>;

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

}  // namespace polhode
