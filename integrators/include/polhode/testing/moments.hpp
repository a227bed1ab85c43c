// SPDX-License-Identifier: Apache-2.0
// Running moments of a sample.
#pragma once

#include <cmath>
#include <cstddef>

namespace polhode::testkit {

/// Mean, variance and skewness, updated with each sample (Welford 1962; the third moment: Terriberry, Pebay 2008,
/// eq. 2.9).
class moments {
 public:
  void add(double x) {
    ++count_;
    const auto n = static_cast<double>(count_);
    const double off = x - mean_, share = off / n, square = off * share * (n - 1);
    mean_ += share;
    cubes_ += square * share * (n - 2) - 3 * share * squares_;
    squares_ += square;
  }

  std::size_t count() const { return count_; }
  double mean() const { return mean_; }
  /// With n - 1; of one sample not finite.
  double variance() const { return squares_ / (static_cast<double>(count_) - 1); }
  double standard_error() const { return std::sqrt(variance() / static_cast<double>(count_)); }
  /// m3 / m2^(3/2); not finite where all samples are equal.
  double skewness() const {
    const auto n = static_cast<double>(count_);
    return cubes_ / n / std::pow(squares_ / n, 1.5);
  }

 private:
  std::size_t count_ = 0;
  double mean_ = 0, squares_ = 0, cubes_ = 0;
};

}  // namespace polhode::testkit
