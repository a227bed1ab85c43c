// SPDX-License-Identifier: Apache-2.0
// "This law is that law": the distance of Kolmogorov and Smirnov, with its exact interval.
//
//   P(sup |F_n - F| > e) <= 2 exp(-2 n e^2),  so  e = sqrt(ln(2/alpha) / (2n))
// for every n and every law (Dvoretzky, Kiefer, Wolfowitz 1956; the constant 2: Massart, Ann. Probab. 18 (1990)
// 1269-1283, Corollary 1). The true distance d = sup |F - G| from the claimed law G lies in D +- e. The claim is
// d <= margin. The width depends on n alone, so n is fixed in advance: 2 ln(2/alpha) / margin^2 samples make it
// margin/2, and then a law with d = 0 holds and one with d > 2 margin is refuted, each with probability 1 - alpha.
//
// What it sees: a shift of 1 % of a standard deviation is d = 0.004, a variance 1 % off is d = 0.0012. Means of powers
// (mean_test.hpp) see these with a tenth of the samples.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <polhode/testing/verdict.hpp>
#include <span>
#include <vector>

namespace polhode::testkit {

/// e of n samples.
inline double dkw_half_width(double n, double alpha) { return std::sqrt(std::log(2 / alpha) / (2 * n)); }

/// How many samples make the half-width margin / 2; of two_law_test, of each sample.
inline std::size_t law_samples(double margin, double alpha) {
  return static_cast<std::size_t>(std::ceil(2 * std::log(2 / alpha) / (margin * margin)));
}
inline std::size_t two_law_samples(double margin, double alpha) { return 4 * law_samples(margin, alpha / 2); }

class law_test : public answer {
 public:
  /// cdf: of the claimed law, P(X <= x); it may have jumps. samples: how many, or 0: law_samples(margin, alpha); a
  /// margin of 0 can only be refuted and needs that number. Throws std::invalid_argument.
  law_test(std::function<double(double)> cdf, double margin, double alpha, std::size_t samples = 0)
      : cdf_(std::move(cdf)), margin_(margin), alpha_(alpha), wanted_(samples) {
    check_claim(0, margin, alpha);
    if (samples == 0 && margin == 0)
      refuse<std::invalid_argument>("margin = 0 with samples = 0: accepted: one of them positive");
    if (samples == 0) wanted_ = law_samples(margin, alpha);
    say(verdict::inconclusive, text("fewer samples than planned (%zu)", wanted_));
  }

  bool wants_more() const { return !closed_; }

  /// Ignored once no more are wanted.
  void add(double x) {
    if (closed_) return;
    samples_.push_back(x);
    if (!std::isfinite(x)) return close(verdict::refuted, text("sample %zu is %g", samples_.size(), x));
    if (samples_.size() == wanted_) look();
  }
  void add(std::span<const double> samples) {
    for (double x : samples) add(x);
  }

 private:
  void close(verdict kind, std::string reason) {
    closed_ = true;
    say(kind, std::move(reason));
  }

  /// sup |F_n - G|: at a sample from the right, and just below it. F_n is constant in between and G rises.
  void look() {
    std::sort(samples_.begin(), samples_.end());
    const auto n = static_cast<double>(samples_.size());
    double distance = 0, where = samples_[0], last = 0;
    for (std::size_t i = 0; i < samples_.size();) {
      const double x = samples_[i];
      const double below = cdf_(std::nextafter(x, -std::numeric_limits<double>::infinity())), at = cdf_(x);
      if (!(below >= last - 1e-12 && at >= below - 1e-12 && at <= 1 + 1e-12))
        return close(verdict::refuted,
                     text("the claimed law is none: %g just below x = %g and %g there", below, x, at));
      const auto begin = static_cast<double>(i);
      while (i < samples_.size() && samples_[i] == x) ++i;
      const double off = std::max(std::fabs(begin / n - below), std::fabs(static_cast<double>(i) / n - at));
      if (off > distance) distance = off, where = x;
      last = at;
    }
    const double e = dkw_half_width(n, alpha_);
    const interval d{std::max(0.0, distance - e), distance + e};
    close(judge(d, 0, margin_), text("distance %.4g [%.4g, %.4g] of %zu samples, the largest at %.6g, against 0 to %g",
                                     distance, d.low, d.high, samples_.size(), where, margin_));
  }

  std::function<double(double)> cdf_;
  double margin_, alpha_;
  std::size_t wanted_;
  std::vector<double> samples_;
  bool closed_ = false;
};

/// Two samples of one law? e is the sum of both half-widths, each at alpha / 2: exact for any two laws, where bounds
/// for equal laws alone (Wei, Dudley, Stat. Probab. Lett. 82 (2012) 636-644) say nothing of a margin.
class two_law_test : public answer {
 public:
  /// Throws std::invalid_argument.
  two_law_test(std::span<const double> first, std::span<const double> second, double margin, double alpha) {
    check_claim(0, margin, alpha);
    if (!first.empty() && !second.empty())
      compare({first.begin(), first.end()}, {second.begin(), second.end()}, margin, alpha);
  }

 private:
  void compare(std::vector<double> a, std::vector<double> b, double margin, double alpha) {
    for (const auto* sample : {&a, &b})
      for (double x : *sample)
        if (!std::isfinite(x)) return say(verdict::refuted, text("a sample is %g", x));
    const auto n = static_cast<double>(a.size()), m = static_cast<double>(b.size());
    const double distance = distance_of(a, b), e = dkw_half_width(n, alpha / 2) + dkw_half_width(m, alpha / 2);
    const interval d{std::max(0.0, distance - e), distance + e};
    say(judge(d, 0, margin), text("distance %.4g [%.4g, %.4g] of %zu and %zu samples, against 0 to %g", distance, d.low,
                                  d.high, a.size(), b.size(), margin));
  }

  static double distance_of(std::vector<double>& a, std::vector<double>& b) {
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    const auto n = static_cast<double>(a.size()), m = static_cast<double>(b.size());
    double distance = 0;
    for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
      const double x = std::min(a[i], b[j]);
      while (i < a.size() && a[i] == x) ++i;
      while (j < b.size() && b[j] == x) ++j;
      distance = std::max(distance, std::fabs(static_cast<double>(i) / n - static_cast<double>(j) / m));
    }
    return distance;
  }
};

}  // namespace polhode::testkit
