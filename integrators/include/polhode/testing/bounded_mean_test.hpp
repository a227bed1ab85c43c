// SPDX-License-Identifier: Apache-2.0
// "The mean of this sample is m", samples known to lie in [a, b]: exact for every law and every n >= 2.
//
// Half-width: the smaller of Hoeffding's, (b-a) sqrt(ln(4/alpha_k) / (2n)), and the empirical Bernstein bound,
//   sqrt(2 V ln(8/alpha_k) / n) + 7 (b-a) ln(8/alpha_k) / (3(n-1)),   V the sample variance with n - 1.
// Each has half of alpha_k. Sources: Hoeffding, J. Amer. Stat. Assoc. 58 (1963) 13-30, Theorem 2; Maurer, Pontil, COLT
// 2009 (arXiv:0907.3740), Theorem 4. Confidence sequences that hold at every n (Howard, Ramdas, McAuliffe, Sekhon,
// Ann. Stat. 49 (2021) 1055-1080) are wider at a given n than these at looks that double.
#pragma once

#include <algorithm>
#include <polhode/testing/sequential_mean.hpp>

namespace polhode::testkit {

struct bounded_width {
  double low = 0, high = 1;

  const char* refuses(double x) const { return x >= low && x <= high ? nullptr : "outside of its bounds"; }

  trusted_width width_at(const moments& m, double alpha) const {
    const auto n = static_cast<double>(m.count());
    const double range = high - low, bernstein = std::log(8 / alpha);
    return {std::min(range * std::sqrt(std::log(4 / alpha) / (2 * n)),
                     std::sqrt(2 * m.variance() * bernstein / n) + 7 * range * bernstein / (3 * (n - 1))),
            {}};
  }
};

class bounded_mean_test : public sequential_mean<bounded_width> {
 public:
  /// bounds: finite, low < high; a sample outside of them refutes. Throws std::invalid_argument.
  bounded_mean_test(double claim, double margin, double alpha, interval bounds, sampling plan = {})
      : sequential_mean(claim, margin, alpha, plan, {bounds.low, bounds.high}) {
    if (!std::isfinite(bounds.low) || !std::isfinite(bounds.high) || !(bounds.low < bounds.high))
      refuse<std::invalid_argument>(
          text("bounds [%g, %g]: accepted: finite, the first smaller", bounds.low, bounds.high));
  }
};

}  // namespace polhode::testkit
