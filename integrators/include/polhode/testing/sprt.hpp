// SPDX-License-Identifier: Apache-2.0
// Wald's sequential probability ratio test between two simple hypotheses: H0, which is claimed, and H1.
//
//   log ratio of the likelihoods, L_n = sum log f1(x_i) / f0(x_i)
//   L_n >= ln(1/alpha): refuted,   L_n <= ln(beta): holds,   else more samples are wanted
//
// With these bounds P0(refuted) <= alpha and P1(holds) <= beta without approximation: exp(L_n) is a martingale of mean
// 1 under H0, exp(-L_n) under H1 (Ville 1939; Wald, Ann. Math. Stat. 16 (1945) 117-186, section 3). Wald's own bounds,
// (1-beta)/alpha and beta/(1-alpha), are as good to first order and keep only the sum of both errors. It stops by the
// verdict; its errors are computed for that. No test with the same errors takes fewer samples on average
// (Wald, Wolfowitz, Ann. Math. Stat. 19 (1948) 326-339). Truths between or beyond H0 and H1 are for mean_test.hpp,
// which knows a margin.
#pragma once

#include <cstddef>
#include <polhode/testing/verdict.hpp>
#include <span>

namespace polhode::testkit {

/// The two hypotheses as one number each, and both error rates: alpha: H0 true and refuted; beta: H1 true and holds.
struct simple_hypotheses {
  double claimed, other;
  double alpha, beta;
};

class sprt : public answer {
 public:
  /// Samples are 0 or 1; probabilities of 1 in [0, 1]. most: then it is inconclusive. Throws std::invalid_argument.
  static sprt bernoulli(const simple_hypotheses& h, std::size_t most) {
    for (double p : {h.claimed, h.other})
      if (!(p >= 0 && p <= 1)) refuse<std::invalid_argument>(text("p = %g: accepted: 0 to 1", p));
    return {h, 0, most};
  }
  /// Normal samples with these means and a known standard deviation sigma > 0. Throws std::invalid_argument.
  static sprt normal(const simple_hypotheses& h, double sigma, std::size_t most) {
    if (!(sigma > 0) || !std::isfinite(sigma))
      refuse<std::invalid_argument>(text("sigma = %g: accepted: a positive number", sigma));
    return {h, sigma, most};
  }

  bool wants_more() const { return !closed_; }

  void add(double x) {
    if (closed_) return;
    ++count_;
    if (!std::isfinite(x) || (sigma_ == 0 && x != 0 && x != 1))
      return close(verdict::refuted, text("sample %zu is %g", count_, x));
    ratio_ += log_ratio(x);
    if (ratio_ >= -std::log(h_.alpha)) return close(verdict::refuted, numbers("claimed, which is refuted"));
    if (ratio_ <= std::log(h_.beta)) return close(verdict::holds, numbers("claimed, which holds"));
    if (count_ == most_) close(verdict::inconclusive, numbers("claimed, and not decided"));
  }
  void add(std::span<const double> samples) {
    for (double x : samples) add(x);
  }

  std::size_t samples() const { return count_; }
  std::string reason() const { return closed_ ? answer::reason() : numbers("claimed, and not decided yet"); }

 private:
  sprt(const simple_hypotheses& h, double sigma, std::size_t most) : h_(h), sigma_(sigma), most_(most) {
    check_claim(h.claimed, 0, h.alpha);
    check_claim(h.other, 0, h.beta);
    if (h.claimed == h.other || most == 0)
      refuse<std::invalid_argument>(
          text("%g against %g, at most %zu samples: accepted: two different numbers, at least "
               "one sample",
               h.claimed, h.other, most));
  }

  double log_ratio(double x) const {
    if (sigma_ > 0) return (h_.other - h_.claimed) / (sigma_ * sigma_) * (x - (h_.other + h_.claimed) / 2);
    return x == 1 ? std::log(h_.other / h_.claimed) : std::log((1 - h_.other) / (1 - h_.claimed));
  }

  std::string numbers(const char* what) const {
    return text("log likelihood ratio %.4g in (%.4g, %.4g) after %zu samples, of %g against %g %s", ratio_,
                std::log(h_.beta), -std::log(h_.alpha), count_, h_.other, h_.claimed, what);
  }

  void close(verdict kind, std::string reason) {
    closed_ = true;
    say(kind, std::move(reason));
  }

  simple_hypotheses h_;
  double sigma_, ratio_ = 0;
  std::size_t most_, count_ = 0;
  bool closed_ = false;
};

}  // namespace polhode::testkit
