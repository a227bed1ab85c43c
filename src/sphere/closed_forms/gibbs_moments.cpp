// SPDX-License-Identifier: Apache-2.0
#include "sphere/closed_forms/gibbs_moments.hpp"

#include <gsl/gsl_sf_bessel.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <numbers>

namespace polhode {
namespace {

using rule = boost::math::quadrature::gauss_kronrod<double, 31>;

constexpr double underflow = 740;   // exp(-740) is the last that is normal
constexpr double wide = 4;          // a panel to the one before
constexpr int deepest = 8;          // bisections of a panel
constexpr double accuracy = 1e-15;  // of a panel
constexpr double moment_rounding = 32 * std::numeric_limits<double>::epsilon();
constexpr double asymptotic = 20;  // from here the series of 1 - r has all digits

struct bessel_ratio {
  double missing, slope;  // 1 - r and r'
};

/// r solves r' = 1 - r / x - r^2, which is a recurrence for the q_k of 1 - r = sum q_k x^-k.
bessel_ratio ratio_from_series(double x) {
  constexpr int terms = 36;
  static const auto q = [] {
    std::array<double, terms + 1> c{0, 0.5};
    for (int m = 2; m <= terms; ++m) {
      double sum = (m - 2) * c[m - 1];
      for (int i = 1; i < m; ++i) sum += c[i] * c[m - i];
      c[m] = 0.5 * sum;
    }
    return c;
  }();
  bessel_ratio out{0, 0};
  double power = 1 / x;
  for (int k = 1; k <= terms; ++k, power /= x) {
    out.missing += q[k] * power;
    out.slope += k * q[k] * power / x;
    if (q[k] * power < 1e-17 * out.missing) break;
  }
  return out;
}

bessel_ratio ratio_at(double x) {
  if (x > asymptotic) return ratio_from_series(x);
  const double r = gsl_sf_bessel_I1_scaled(x) / gsl_sf_bessel_I0_scaled(x);
  return {1 - r, x > 1e-4 ? 1 - r / x - r * r : 0.5 - 3 * x * x / 16};
}

struct sum {
  double value = 0, error = 0;
};

class law_of_t {
 public:
  law_of_t(double a, double b, double beta) : slow_(beta * b), half_gap_(beta * (a - b) / 2) {}

  /// Integral of g(t, x) over the law, not normalised.
  template <class G>
  sum integrate(const G& g) const {
    const auto weighted = [&](double t) {
      const double x = half_gap_ * t;
      return std::exp(-slow_ * t) * gsl_sf_bessel_I0_scaled(x) * g(t, x);
    };
    sum out;
    const auto add = [&](const auto& f, double low, double high) {  // on [-1, 1], as Boost does not scale its error
      const double middle = (low + high) / 2, half = (high - low) / 2;
      double error = 0;
      out.value +=
          rule::integrate([&](double u) { return half * f(middle + half * u); }, -1.0, 1.0, deepest, accuracy, &error);
      out.error += error;
    };
    const auto beside_the_pole = [&](double t) { return weighted(t) / (2 * std::sqrt(1 - t)); };
    const double narrow = 1 / std::max(2.0, slow_ + 2 * half_gap_);
    for (double low = 0, high = narrow; low < 0.5 && slow_ * low < underflow; low = high, high *= wide)
      add(beside_the_pole, low, high = std::min(high, 0.5));
    const auto around_the_equator = [&](double z) { return weighted((1 - z) * (1 + z)); };
    if (slow_ / 2 < underflow) add(around_the_equator, 0, 1 / std::numbers::sqrt2);
    return out;
  }

 private:
  double slow_, half_gap_;
};

}  // namespace

bingham_moments bingham(double a, double b, double beta) {
  const law_of_t law(a, b, beta);
  const double d = (a - b) / 2;
  const auto mean_at = [=](double t, double x) { return t * (b + d * ratio_at(x).missing); };
  const sum total = law.integrate([](double, double) { return 1.0; });
  bingham_moments out;
  out.relative_uncertainty = moment_rounding + total.error / total.value;
  const auto expected = [&](const auto& g) {
    const sum s = law.integrate(g);
    if (s.value > 0)
      out.relative_uncertainty =
          std::max(out.relative_uncertainty, moment_rounding + s.error / s.value + total.error / total.value);
    return s.value / total.value;
  };
  out.square[0] = expected([](double t, double x) { return t * ratio_at(x).missing / 2; });
  out.square[1] = expected([](double t, double x) { return t * (1 - ratio_at(x).missing / 2); });
  out.square[2] = expected([](double t, double) { return 1 - t; });
  out.mean = expected(mean_at);
  out.variance = expected([&](double t, double x) {
    const double off = mean_at(t, x) - out.mean, wave = t * d;
    return off * off + wave * wave * ratio_at(x).slope;
  });
  return out;
}

}  // namespace polhode
