// Values without sampling error as a power series in dt, y = c_0 + c_1 dt + c_2 dt^2 + …
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "statistics/sample.hpp"

namespace polhode {

/// The first coefficients, by the polynomial through all levels (Richardson's extrapolation to dt = 0), which have
/// different dt. Half-width of an interval: three times the change from the polynomial without the coarsest level, that
/// is the next term of the series (or an eighth of the change before, should that term happen to vanish), and what the
/// values are uncertain by, each at its worst. At least count + 2 levels.
std::vector<interval_estimate> series_coefficients(std::span<const double> dt, std::span<const double> value,
                                                   std::span<const double> uncertainty, std::size_t count);

}  // namespace polhode
