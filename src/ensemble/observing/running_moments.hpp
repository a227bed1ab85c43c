// SPDX-License-Identifier: Apache-2.0
// Mean and variance without cancellation, mergeable in a fixed order.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace polhode {

/// Source: Chan, Golub, LeVeque, Amer. Statist. 37 (1983) 242-247, eqs. (1.2) and (2.1).
struct running_moments {
  std::int64_t count = 0;
  double mean = 0, squares = 0;

  /// Of these values, in two passes.
  static running_moments of(std::span<const double> values) {
    if (values.empty()) return {};
    const auto n = static_cast<double>(values.size());
    const double mean = sum(values, [](double x) { return x; }) / n;
    return {static_cast<std::int64_t>(values.size()), mean,
            sum(values, [mean](double x) { return (x - mean) * (x - mean); })};
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

 private:
  /// Every eighth value into one of eight sums: no addition waits for the one before.
  template <class F>
  static double sum(std::span<const double> values, F f) {
    std::array<double, 8> part{};
    std::size_t i = 0;
    for (; i + part.size() <= values.size(); i += part.size())
      for (std::size_t k = 0; k < part.size(); ++k) part[k] += f(values[i + k]);
    for (std::size_t k = 0; i < values.size(); ++i, ++k) part[k] += f(values[i]);
    return ((part[0] + part[1]) + (part[2] + part[3])) + ((part[4] + part[5]) + (part[6] + part[7]));
  }
};

}  // namespace polhode
