// SPDX-License-Identifier: Apache-2.0
// Floating-point operations of a step as it is written, by a scalar that counts them.
#pragma once

#include <array>
#include <string_view>

namespace polhode::bench {

/// Scenes of the systems whose states fit into registers.
inline constexpr std::array<std::string_view, 3> other_scenes{"so4", "heavy_top", "spin_pair"};

/// Additions, multiplications, divisions and roots of one path and step of a main scheme with common noise on one of
/// these, a fused one counted as two; the noise itself, which all paths share, is not counted.
double counted_flops(std::string_view scheme, std::string_view scene);

}  // namespace polhode::bench
