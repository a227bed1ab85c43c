// Mean and variance without cancellation, mergeable in a fixed order.
#pragma once

#include <cmath>
#include <cstdint>

namespace polhode {

/// Source: Chan, Golub, LeVeque, Amer. Statist. 37 (1983) 242-247, eq. (2.1).
struct running_moments {
  std::int64_t count = 0;
  double mean = 0, squares = 0;

  void add(double x) {
    const double from_mean = x - mean;
    mean += from_mean / static_cast<double>(++count);
    squares += from_mean * (x - mean);
  }
  void merge(const running_moments& other) {
    if (other.count == 0) return;
    const auto mine = static_cast<double>(count), theirs = static_cast<double>(other.count);
    const double apart = other.mean - mean;
    mean += apart * theirs / (mine + theirs);
    squares += other.squares + apart * apart * mine * theirs / (mine + theirs);
    count += other.count;
  }
  /// Of the sample; NaN for fewer than two values.
  double deviation() const { return std::sqrt(squares / static_cast<double>(count - 1)); }
};

}  // namespace polhode
