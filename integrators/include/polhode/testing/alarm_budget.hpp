// SPDX-License-Identifier: Apache-2.0
// One probability of a false alarm for a whole suite, shared out over its tests.
//
// Test number k of any number of tests gets total 6 / (pi k)^2; the shares add up to the total (Euler). Where the
// number of tests is known, equal shares are larger from the second test on. By Bonferroni's inequality the probability
// that any healthy test of the suite is refuted is at most the total, however the tests depend on each other.
//
// next() counts in one process. Where each test runs in a process of its own (ctest with gtest_discover_tests,
// pytest-xdist), each would be the first there: number them and use share(k).
#pragma once

#include <numbers>
#include <polhode/testing/verdict.hpp>

namespace polhode::testkit {

class alarm_budget {
 public:
  /// total: in (0, 1); tests: how many, in equal shares, or 0: any number. Throws std::invalid_argument.
  explicit alarm_budget(double total, int tests = 0) : total_(total), tests_(tests) {
    if (!(total > 0 && total < 1))
      refuse<std::invalid_argument>(text("budget = %g: accepted: a probability between 0 and 1", total));
    if (tests < 0) refuse<std::invalid_argument>(text("tests = %d: accepted: 0 (any number) or more", tests));
  }

  /// alpha of test number k = 1, 2, …; each number is for one test. Throws std::out_of_range.
  double share(int k) const {
    if (k < 1 || (tests_ > 0 && k > tests_))
      refuse<std::out_of_range>(
          text("test number %d: accepted: 1 to %s", k, tests_ > 0 ? std::to_string(tests_).c_str() : "any"));
    const double pi_k = std::numbers::pi * k;
    return tests_ > 0 ? total_ / tests_ : total_ * 6 / (pi_k * pi_k);
  }

  /// alpha of the next test. Not for two threads at a time.
  double next() {
    const double alpha = share(given_ + 1);
    ++given_;
    return alpha;
  }

  double total() const { return total_; }
  int given() const { return given_; }

 private:
  double total_;
  int tests_, given_ = 0;
};

}  // namespace polhode::testkit
