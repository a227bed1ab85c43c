// SPDX-License-Identifier: Apache-2.0
// Series in the bracket of any Lie algebra.
#pragma once

#include <polhode/vec.hpp>

namespace polhode {

/// The inverse of the differential of exp, sum_k B_k/k! ad_u^k v to k = 14: right to rounding where |ad_u| < 1 or so.
template <class G, class Element>
Element dexp_inv_by_series(const Element& u, const Element& v) {
  using S = typename Element::scalar;
  constexpr double b[] = {
      1.0 / 12, -1.0 / 720, 1.0 / 30240, -1.0 / 1209600, 1.0 / 47900160, -691.0 / 1307674368000.0, 1.0 / 74724249600.0};
  auto term = G::bracket(u, v);
  auto sum = v - S(0.5) * term;
  for (const double coefficient : b) {
    term = G::bracket(u, term);
    sum = sum + S(coefficient) * term;
    term = G::bracket(u, term);
  }
  return sum;
}

}  // namespace polhode
