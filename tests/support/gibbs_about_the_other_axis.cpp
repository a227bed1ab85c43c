// SPDX-License-Identifier: Apache-2.0
#include "support/gibbs_about_the_other_axis.hpp"

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <numbers>

namespace polhode::test {
namespace {

/// exp(-x) I_0(x) and 1 - I_1 / I_0 in long double, by Boost and by the first terms of their asymptotic series.
std::pair<long double, long double> bessel_in_long_double(long double x) {
  if (x < 500) {
    const long double i0 = boost::math::cyl_bessel_i(0, x), i1 = boost::math::cyl_bessel_i(1, x);
    return {std::exp(-x) * i0, (i0 - i1) / i0};
  }
  long double zero = 1, difference = 0, term0 = 1, term1 = 1;
  for (int k = 1; k < 12; ++k) {
    const auto odd = static_cast<long double>((2 * k - 1) * (2 * k - 1));
    zero += term0 *= odd / (8 * k * x);
    difference += term0 - (term1 *= -(4 - odd) / (8 * k * x));
  }
  return {zero / std::sqrt(2 * std::numbers::pi_v<long double> * x), difference / zero};
}

}  // namespace

std::array<double, 4> gibbs_about_the_other_axis(std::array<double, 3> i, double c, double beta) {
  using real = long double;
  std::ranges::sort(i);
  const real a = real(c) * c * (real(i[2]) - i[0]) / (2 * real(i[0]) * i[2]);
  const real b = real(c) * c * (real(i[2]) - i[1]) / (2 * real(i[1]) * i[2]);
  std::array<real, 5> sum{};
  // x_1 = z, x_2 = sqrt(1 - z^2) sin: weight exp(-beta a z^2 - beta b (1 - z^2) sin^2); panels that widen
  const auto panel = [&](auto z_at, real low, real high) {
    const auto& nodes = boost::math::quadrature::gauss<real, 30>::abscissa();
    const auto& weights = boost::math::quadrature::gauss<real, 30>::weights();
    for (std::size_t n = 0; n < 2 * nodes.size(); ++n) {
      const real u = (n % 2 == 0 ? 1 : -1) * nodes[n / 2], at = (low + high) / 2 + (high - low) / 2 * u;
      const auto [z2, rest, slope] = z_at(at);
      const auto [i0, missing] = bessel_in_long_double(beta * b * rest / 2);
      const real w = weights[n / 2] * (high - low) / 2 * slope * std::exp(-beta * a * z2) * i0;
      sum[0] += w;
      sum[1] += w * z2;
      sum[2] += w * rest * missing / 2;
      sum[3] += w * rest * (1 - missing / 2);
    }
  };
  const auto from_equator = [](real z) { return std::array<real, 3>{z * z, (1 - z) * (1 + z), 1}; };
  const auto from_pole = [](real rest) { return std::array<real, 3>{1 - rest, rest, 0.5L / std::sqrt(1 - rest)}; };
  const real narrow = std::min(0.25L, 0.5L / std::sqrt(1 + beta * a)), half = 0.5L;
  for (real low = 0, high = narrow; low < std::sqrt(half); low = high, high *= 1.7L)
    panel(from_equator, low, high = std::min(high, std::sqrt(half)));
  for (real low = 0, high = std::min(half, 1 / (2 + beta * b)); low < half; low = high, high *= 2)
    panel(from_pole, low, high = std::min(high, half));
  const auto mean = [&](int k) { return sum[static_cast<std::size_t>(k)] / sum[0]; };
  const real square = real(c) * c;
  return {double(square * mean(1)), double(square * mean(2)), double(square * mean(3)),
          double(a * mean(1) + b * mean(2))};
}

}  // namespace polhode::test
