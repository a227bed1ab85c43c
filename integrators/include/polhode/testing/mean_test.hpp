// SPDX-License-Identifier: Apache-2.0
// "The mean of this sample is m", variance estimated: Student's interval.
//
//   mean +- t_{n-1}(alpha_k / 2) s / sqrt n                                     (sequential_mean.hpp: looks and
//   spending)
//
// Exact at each look for normal samples, any n >= 2. For others the tail of Student's statistic at x is that of the
// normal times exp(-+ x^3 g / (3 sqrt n)), g the skewness (Wang, Electron. J. Probab. 10 (2005) 1260-1285, abstract and
// Theorem 1.1; fourth moments finite). A look therefore counts only where x^3 |g| / (3 sqrt n) <= 1/2: then both tails
// together are at most cosh(1/2) = 1.13 times what is declared. At alpha_k = 1e-4 that asks for n >= 1,540 g^2, at
// 1e-6 for 6,100 g^2: nothing of symmetric samples, 6,200 and 24,400 of exponential ones. Samples of an infinite
// variance have a skewness like sqrt n and never count. Samples are taken to be independent: means of blocks, where
// they are not. Bounds that need none of this: bounded_mean_test.hpp.
#pragma once

#include <polhode/testing/quantiles.hpp>
#include <polhode/testing/sequential_mean.hpp>

namespace polhode::testkit {

struct student_width {
  const char* refuses(double x) const { return std::isfinite(x) ? nullptr : "not a finite number"; }

  trusted_width width_at(const moments& m, double alpha) const {
    if (m.variance() == 0) return {INFINITY, "equal samples tell nothing of their spread"};
    const auto n = static_cast<double>(m.count());
    const double x = student_deviate(alpha / 2, n - 1), skew = m.skewness();
    const double wanted = std::pow(x * x * x * skew / 1.5, 2);
    if (!(n >= wanted))
      return {INFINITY, text("skewness %.2g: Student's interval is not trusted below %.3g samples", skew, wanted)};
    return {x * m.standard_error(), {}};
  }
};

class mean_test : public sequential_mean<student_width> {
 public:
  /// alpha: of any false verdict; see alarm_budget.hpp. Throws std::invalid_argument.
  mean_test(double claim, double margin, double alpha, sampling plan = {})
      : sequential_mean(claim, margin, alpha, plan, {}) {}
};

}  // namespace polhode::testkit
