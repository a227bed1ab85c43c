// SPDX-License-Identifier: Apache-2.0
// How much of a computed number is rounding? By differences of values at equally spaced inputs so close that the
// function itself is a polynomial of low degree there: the k-th difference of independent errors of variance s^2 has
// the variance s^2 (2k)! / (k!)^2. Source: Hamming, Introduction to Applied Numerical Analysis (1971), ch. 6; More,
// Wild, SIAM J. Sci. Comput. 33 (2011) 1292-1314 (ECNoise).
#pragma once

#include <span>

namespace polhode {

/// The order of the difference, one less than the values needed.
inline constexpr int noise_difference = 6;

/// Square of the noise's standard deviation from noise_difference + 1 values.
double squared_rounding_noise(std::span<const double> values);

}  // namespace polhode
