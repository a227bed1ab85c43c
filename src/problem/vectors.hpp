// SPDX-License-Identifier: Apache-2.0
// States of any dimension.
#pragma once

#include <array>
#include <cmath>
#include <span>

namespace polhode {

inline double length(std::span<const double> a) {
  double square = 0;
  for (const double x : a) square += x * x;
  return std::sqrt(square);
}

inline double distance(std::span<const double> a, std::span<const double> b) {
  double square = 0;
  for (std::size_t i = 0; i < a.size(); ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(square);
}

/// The first three components.
inline std::array<double, 3> three(std::span<const double> a) { return {a[0], a[1], a[2]}; }

}  // namespace polhode
