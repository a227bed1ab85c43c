// SPDX-License-Identifier: Apache-2.0
// "The mean of this sample is m": samples come until the interval is tight; what mean_test and bounded_mean_test share.
//
// Looks are fixed in advance: at first, 2 first, 4 first, …, most samples. Each of the K looks spends alpha / K, so
// that all K intervals hold the mean at once with probability 1 - alpha (Bonferroni; group-sequential with equal
// spending, Lan, DeMets, Biometrika 70 (1983) 659-663). Whoever reads verdicts between looks, or stops early, therefore
// has the same error. At a look sampling stops by the width of the interval alone (half-width <= margin / 2), never by
// the verdict, as Chow and Robbins do (Ann. Math. Stat. 36 (1965) 457-462), who spend nothing and are right as the
// width falls to zero.
//
// What follows, with probability 1 - alpha: a mean equal to the claim holds, one that is off by more than 2 margins is
// refuted, and in between nothing false is said; provided `most` is enough for the width.
#pragma once

#include <cstddef>
#include <polhode/testing/moments.hpp>
#include <polhode/testing/verdict.hpp>
#include <span>

namespace polhode::testkit {

/// Numbers of samples at the first and the last look: 2 <= first <= most.
struct sampling {
  std::size_t first = 128, most = std::size_t{1} << 20;

  /// The look after the one at n samples; the last is at `most`.
  std::size_t after(std::size_t n) const { return most / 2 < n ? most : 2 * n; }

  int looks() const {
    int count = 1;
    std::size_t end = first;
    while (end < most) end = after(end), ++count;
    return count;
  }
};

/// A half-width, not finite where it cannot be trusted; then why.
struct trusted_width {
  double half;
  std::string distrust;
};

/// Rule: `const char* refuses(double) const`, why a sample is none, or null; `trusted_width width_at(const moments&,
/// double alpha) const`.
template <class Rule>
class sequential_mean : public answer {
 public:
  /// margin 0: never holds; all `most` samples are taken. Throws std::invalid_argument.
  sequential_mean(double claim, double margin, double alpha, sampling plan, Rule rule)
      : claim_(claim), margin_(margin), plan_(plan), rule_(rule), next_look_(plan.first) {
    check_claim(claim, margin, alpha);
    if (plan.first < 2 || plan.most < plan.first)
      refuse<std::invalid_argument>(
          text("first = %zu, most = %zu: accepted: 2 <= first <= most", plan.first, plan.most));
    alpha_at_a_look_ = alpha / plan.looks();
    say(verdict::inconclusive, text("fewer samples than the first look asks for (%zu)", plan.first));
  }

  bool wants_more() const { return !closed_; }

  /// Ignored once no more are wanted: the verdict does not depend on how samples are cut into batches.
  void add(double x) {
    if (closed_) return;
    if (const char* why = rule_.refuses(x)) {
      closed_ = true;
      say(verdict::refuted, text("sample %zu is %g: %s", moments_.count() + 1, x, why));
      return;
    }
    moments_.add(x);
    if (moments_.count() == next_look_) look();
  }
  void add(std::span<const double> samples) {
    for (double x : samples) add(x);
  }

  std::size_t samples() const { return moments_.count(); }
  double mean() const { return moments_.mean(); }
  interval at_last_look() const { return interval_; }

 private:
  void look() {
    const auto [half, distrust] = rule_.width_at(moments_, alpha_at_a_look_);
    const double mean = moments_.mean();
    interval_ = {mean - half, mean + half};
    closed_ = half <= margin_ / 2 || next_look_ == plan_.most;
    next_look_ = plan_.after(next_look_);
    if (moments_.variance() == 0 && distrust.size()) return constant(distrust);
    if (distrust.size())
      return say(verdict::inconclusive, text("mean %.6g of %zu samples against %g +- %g: %s", mean, moments_.count(),
                                             claim_, margin_, distrust.c_str()));
    const auto kind = judge(interval_, claim_, margin_);
    say(kind, text("mean %.6g [%.6g, %.6g] of %zu samples against %g +- %g%s", mean, interval_.low, interval_.high,
                   moments_.count(), claim_, margin_, hint(kind, half)));
  }

  /// Equal samples have no spread to judge by: off the claim they refute it, on it they prove nothing.
  void constant(const std::string& distrust) {
    const bool off = std::fabs(moments_.mean() - claim_) > margin_;
    say(off ? verdict::refuted : verdict::inconclusive,
        text("all %zu samples are %.6g, against %g +- %g%s%s", moments_.count(), moments_.mean(), claim_, margin_,
             off ? "" : ": ", off ? "" : distrust.c_str()));
  }

  const char* hint(verdict kind, double half) const {
    if (kind != verdict::inconclusive) return "";
    if (margin_ == 0) return ": a margin of 0 can only be refuted";
    return half <= margin_ / 2 ? ": on the edge of the margin" : ": more samples are wanted";
  }

  double claim_, margin_, alpha_at_a_look_ = 0;
  sampling plan_;
  Rule rule_;
  moments moments_;
  interval interval_;
  std::size_t next_look_;
  bool closed_ = false;
};

}  // namespace polhode::testkit
