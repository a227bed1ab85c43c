// SPDX-License-Identifier: Apache-2.0
// Which bins of a snapshot the samples of a picture see, row by row.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace polhode::report {

inline constexpr auto outside = std::numeric_limits<std::uint32_t>::max();  ///< no bin: beside the sphere
using sample_row = std::vector<std::uint32_t>;

/// Samples at x = (k + 1/2)/w - 1 of the row at y in (-1, 1), upwards, k = 0 … 2w - 1, on the unit disc: Mollweide's
/// projection of the whole sphere, and the hemispheres z >= 0 and z < 0 seen from outside (orthographic). Bins as in
/// ensemble_snapshot::picture, in squares of side^2.
void mollweide_row(int side, double y, sample_row& out);
void upper_row(int side, double y, sample_row& out);
void lower_row(int side, double y, sample_row& out);

}  // namespace polhode::report
