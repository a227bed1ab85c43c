// The pack type: as many doubles as one register of the target holds.
#pragma once

#include <experimental/simd>

namespace polhode {

namespace stdx = std::experimental;

using pack = stdx::native_simd<double>;

template <class S>
inline constexpr bool is_pack = stdx::is_simd_v<S>;

}  // namespace polhode
