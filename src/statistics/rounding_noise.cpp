// SPDX-License-Identifier: Apache-2.0
#include "statistics/rounding_noise.hpp"

#include <boost/math/special_functions/binomial.hpp>

namespace polhode {

double squared_rounding_noise(std::span<const double> values) {
  constexpr int k = noise_difference;
  double difference = 0;
  for (int i = 0; i <= k; ++i)
    difference += (i % 2 ? -1 : 1) * boost::math::binomial_coefficient<double>(k, static_cast<unsigned>(i)) *
                  values[static_cast<std::size_t>(i)];
  return difference * difference / boost::math::binomial_coefficient<double>(2 * k, k);
}

}  // namespace polhode
