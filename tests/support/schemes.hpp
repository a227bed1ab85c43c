// SPDX-License-Identifier: Apache-2.0
// Every scheme of the list, for typed tests.
#pragma once

#include <gtest/gtest.h>

#include <polhode/noise/normal.hpp>
#include <polhode/systems/rigid_body.hpp>

#include "support/so4_body.hpp"
#include "systems/schemes.hpp"

namespace polhode::test {

template <class List>
struct as_types;
template <class... Schemes>
struct as_types<scheme_list<Schemes...>> {
  using type = testing::Types<Schemes...>;
};
using every_scheme = as_types<all_schemes>::type;

inline rigid_body paper_body(double theta = 0.5, double sigma = 0.5) {
  return rigid_body({1, 2, 3}, theta, rigid_body::isotropic(sigma));
}
inline constexpr vec<double, 3> paper_momentum{{0.6, 0.48, 0.64}};

/// Of step `step` of one path: increments, and areas of their size.
template <int M>
wiener_levy<double, M> some_increment(double dt, std::uint64_t step) {
  wiener_levy<double, M> w;
  w.dt = dt;
  w.dw = std::sqrt(dt) * normals<M>({7, noise_kind::increment, 3, step});
  w.area = (dt / 2) * normals<pairs_of<M>>({7, noise_kind::area, 3, step});
  return w;
}

template <int N>
double distance(const vec<double, N>& a, const vec<double, N>& b) {
  return std::sqrt(dot(a - b, a - b));
}

}  // namespace polhode::test
