// SPDX-License-Identifier: Apache-2.0
// "This slope is p": errors at several step sizes, a line through their logarithms, an interval of its slope.
//
//   log e_i = c + p log dt_i,   half-width = z s max(1, sqrt(chi2 / (L-2))) + bend
//   bend = 2 |p_1 - p_fine| + |p - p_1|,   p_1: the slope without weights, p_fine: that of the finer half of the levels
// s: of the weighted fit of L levels; chi2: its weighted squared residuals (Birge's ratio widens where errors scatter
// by more than they should); z: normal deviate of alpha / 2. Of an error C dt^p (1 + c dt), dt halved from level to
// level or more, p_1 is off by less than 2 |p_1 - p_fine|; so the bend covers what is not asymptotic yet. Each term
// widens the exact interval of a straight line with normal errors, whose slope is missed with probability alpha.
//
// Paths that share their noise: the standard error of the slope is that of sum_i (dp/dlog e_i) e_ip / e_i over paths p,
// by Student's law and under the rule of mean_test.hpp on skewness.
//
// Relative standard errors r_i enter the logarithm as -log(1 - z r_i) / z, no less than what log does to a deviation of
// z; so nothing is linearised. Where z r_i > 1/2 nothing is concluded: more paths are wanted there.
#pragma once

#include <algorithm>
#include <cstddef>
#include <polhode/testing/mean_test.hpp>
#include <span>
#include <vector>

namespace polhode::testkit {

/// Weighted least squares; variance: of the slope where 1 / weight is that of y; chi2: weighted squared residuals.
struct line_fit {
  double slope = 0, variance = 0, chi2 = 0;

  line_fit(std::span<const double> x, std::span<const double> y, std::span<const double> weight) {
    double w = 0, mean_x = 0, mean_y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) w += weight[i], mean_x += weight[i] * x[i], mean_y += weight[i] * y[i];
    mean_x /= w, mean_y /= w;
    for (std::size_t i = 0; i < x.size(); ++i) {
      xx += weight[i] * (x[i] - mean_x) * (x[i] - mean_x);
      xy += weight[i] * (x[i] - mean_x) * (y[i] - mean_y);
    }
    slope = xy / xx;
    variance = 1 / xx;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double residual = y[i] - mean_y - slope * (x[i] - mean_x);
      chi2 += weight[i] * residual * residual;
    }
  }
};

class slope_test : public answer {
 public:
  /// dt: at least four, in any order, each at most half of the one before; errors: one a dt; standard_errors: one a dt,
  /// independent of each other (levels that share their paths: of_paths), or none, where the errors are exact. Throws
  /// std::invalid_argument.
  slope_test(std::span<const double> dt, std::span<const double> errors, std::span<const double> standard_errors,
             double claim, double margin, double alpha)
      : claim_(claim), margin_(margin), alpha_(alpha) {
    check(dt);
    if (errors.size() != dt.size() || (!standard_errors.empty() && standard_errors.size() != dt.size()))
      refuse<std::invalid_argument>(
          text("%zu dt, %zu errors, %zu standard errors: accepted: as many of each, or no "
               "standard errors",
               dt.size(), errors.size(), standard_errors.size()));
    if (std::ranges::any_of(standard_errors, [](double se) { return se == 0; }))
      refuse<std::invalid_argument>("standard errors: accepted: all positive, or none given");
    levels l;
    const double z = normal_deviate(alpha / 2);
    for (std::size_t i : finest_last(dt)) {
      const double se = standard_errors.empty() ? 0 : standard_errors[i];
      if (!usable(dt[i], errors[i], se, z)) return;
      const double sd = se > 0 ? -std::log1p(-z * se / errors[i]) / z : 0;
      l.add(dt[i], errors[i], sd);
    }
    of_independent(l, z);
  }

  /// per_path: [path][level], errors whose means over the paths are the errors at each dt; the paths are independent
  /// and the levels of a path need not be. Root-mean-square errors: squares, with claim and margin doubled.
  static slope_test of_paths(std::span<const double> dt, std::span<const double> per_path, double claim, double margin,
                             double alpha) {
    return {shared_paths{}, dt, per_path, claim, margin, alpha};
  }

  double slope() const { return slope_; }
  interval range() const { return range_; }

 private:
  struct shared_paths {};
  struct levels {
    std::vector<double> x, y, weight;
    bool exact = true;

    void add(double dt, double error, double sd) {
      x.push_back(std::log(dt)), y.push_back(std::log(error)), weight.push_back(sd > 0 ? 1 / (sd * sd) : 1);
      exact = exact && sd == 0;
    }
    line_fit fit() const { return {x, y, weight}; }
    double bend(double slope) const {
      const std::vector<double> equal(x.size(), 1.0);
      const std::size_t fine = x.size() / 2;
      const double plain = line_fit(x, y, equal).slope;
      const double finer =
          line_fit(std::span(x).subspan(fine), std::span(y).subspan(fine), std::span(equal).subspan(fine)).slope;
      return 2 * std::fabs(plain - finer) + std::fabs(slope - plain);
    }
  };

  slope_test(shared_paths, std::span<const double> dt, std::span<const double> per_path, double claim, double margin,
             double alpha)
      : claim_(claim), margin_(margin), alpha_(alpha) {
    check(dt);
    const std::size_t paths = per_path.size() / dt.size();
    if (paths * dt.size() != per_path.size())
      refuse<std::invalid_argument>(
          text("%zu errors of paths: accepted: a multiple of the %zu dt", per_path.size(), dt.size()));
    of_shared(dt, per_path, paths);
  }

  void of_shared(std::span<const double> dt, std::span<const double> per_path, std::size_t paths) {
    if (paths < 2) return say(verdict::inconclusive, text("%zu paths: at least 2 are wanted", paths));
    const std::size_t count = dt.size();
    std::vector<moments> each(count);
    for (std::size_t i = 0; i < per_path.size(); ++i) each[i % count].add(per_path[i]);
    levels l;
    const double t = student_deviate(alpha_ / 2, static_cast<double>(paths - 1));
    const auto order = finest_last(dt);
    for (std::size_t i : order) {
      if (!usable(dt[i], each[i].mean(), each[i].standard_error(), t)) return;
      l.add(dt[i], each[i].mean(), 0);
    }
    const auto fit = l.fit();
    double mean_x = 0;
    for (double x : l.x) mean_x += x / static_cast<double>(count);
    moments influence;  // of a path on the slope
    for (std::size_t p = 0; p < paths; ++p) {
      double sum = 0;
      for (std::size_t k = 0; k < count; ++k)
        sum += (l.x[k] - mean_x) * fit.variance * per_path[p * count + order[k]] / each[order[k]].mean();
      influence.add(sum);
    }
    const auto [half, distrust] = student_width{}.width_at(influence, alpha_);
    if (!distrust.empty())
      return say(verdict::inconclusive, text("slope %.4f of %zu paths: %s", fit.slope, paths, distrust.c_str()));
    finish(fit.slope, half + l.bend(fit.slope), text("%zu dt of %zu paths", count, paths));
  }

  void check(std::span<const double> dt) const {
    check_claim(claim_, margin_, alpha_);
    std::vector<double> sorted(dt.begin(), dt.end());
    std::sort(sorted.begin(), sorted.end());
    bool apart = sorted.size() >= 4 && sorted.front() > 0 && std::isfinite(sorted.back());
    for (std::size_t i = 1; apart && i < sorted.size(); ++i) apart = sorted[i] > 1.999 * sorted[i - 1];
    if (!apart)
      refuse<std::invalid_argument>("dt: accepted: at least four positive numbers, each half of another or less");
  }

  /// The levels from the coarsest to the finest.
  static std::vector<std::size_t> finest_last(std::span<const double> dt) {
    std::vector<std::size_t> order(dt.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return dt[a] > dt[b]; });
    return order;
  }

  bool usable(double dt, double error, double se, double z) {
    if (!std::isfinite(error) || !std::isfinite(se) || se < 0 || error < 0)
      return say(verdict::refuted, text("error %g +- %g at dt = %g", error, se, dt)), false;
    if (error == 0) return say(verdict::inconclusive, text("error 0 at dt = %g has no logarithm", dt)), false;
    if (z * se > error / 2)
      return say(verdict::inconclusive, text("error %.3g +- %.2g at dt = %g is not clear of its noise: %.0f times as "
                                             "many samples are wanted there",
                                             error, se, dt, std::ceil(std::pow(2 * z * se / error, 2)))),
             false;
    return true;
  }

  void of_independent(const levels& l, double z) {
    const auto fit = l.fit();
    const double birge = std::sqrt(fit.chi2 / static_cast<double>(l.x.size() - 2));
    finish(fit.slope, z * std::sqrt(fit.variance) * (l.exact ? birge : std::max(1.0, birge)) + l.bend(fit.slope),
           text("%zu dt", l.x.size()));
  }

  void finish(double slope, double half, const std::string& what) {
    slope_ = slope;
    range_ = {slope - half, slope + half};
    say(judge(range_, claim_, margin_), text("slope %.4f [%.4f, %.4f] of %s against %g +- %g", slope, range_.low,
                                             range_.high, what.c_str(), claim_, margin_));
  }

  double claim_, margin_, alpha_, slope_ = 0;
  interval range_;
};

}  // namespace polhode::testkit
