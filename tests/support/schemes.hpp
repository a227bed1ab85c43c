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

template <int N>
double distance(const vec<double, N>& a, const vec<double, N>& b) {
  return std::sqrt(dot(a - b, a - b));
}

}  // namespace polhode::test
