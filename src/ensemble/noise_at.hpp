// SPDX-License-Identifier: Apache-2.0
// The noise of one step as a system bound to its step size sees it: none, one for every path, or one for all.
#pragma once

#include <array>

#include <polhode/increment.hpp>
#include <polhode/lie/so3.hpp>
#include <polhode/simd.hpp>
#include <polhode/systems/constant_noise.hpp>

namespace polhode {

/// No noise: the terms vanish from the step.
struct no_noise {
  static constexpr bool shared = false;
  zero_vector noise(const auto&) const { return {}; }
  zero_vector area_noise(const auto&) const { return {}; }
  zero_vector ito_drift(const auto&) const { return {}; }
};

/// sigma_i = scale_i e_i on so(3). Any other sigma comes to this by writing B = sum sigma_i W^i in the basis e_i first.
struct diagonal_noise {
  static constexpr bool shared = false;
  vec<double, 3> scale{{1, 1, 1}};        ///< over the unit in which increments come
  vec<double, 3> area_scale{{1, -1, 1}};  ///< [sigma_2,sigma_3], [sigma_1,sigma_3], [sigma_1,sigma_2]
  std::array<vec<double, 3>, 3> ito{};    ///< 1/2 sum_i ad*_{sigma_i}^2, by rows

  template <class S>
  vec<S, 3> noise(const vec<S, 3>& dw) const {
    vec<S, 3> b = scaled(scale, dw);
    for (int k = 0; k < 3; ++k) b[k] = rounded_product(b[k]);
    return b;
  }
  /// Pairs (1,2), (1,3), (2,3): [e_1,e_2] = e_3, [e_1,e_3] = -e_2, [e_2,e_3] = e_1.
  template <class S>
  vec<S, 3> area_noise(const vec<S, 3>& area) const {
    return {{S(area_scale[0]) * area[2], S(area_scale[1]) * area[1], S(area_scale[2]) * area[0]}};
  }
  template <class S>
  vec<S, 3> ito_drift(const vec<S, 3>& mu) const {
    vec<S, 3> out;
    for (int k = 0; k < 3; ++k)
      out[k] = S(ito[static_cast<std::size_t>(k)][0]) * mu[0] + S(ito[static_cast<std::size_t>(k)][1]) * mu[1] +
               S(ito[static_cast<std::size_t>(k)][2]) * mu[2];
    return out;
  }
};

/// Any constant noise, of which sum sigma_i dW^i stands in the place of the increment.
struct summed_noise {
  static constexpr bool shared = false;
  template <class S>
  vec<S, 3> noise(const vec<S, 3>& b) const {
    return b;
  }
};

/// What all paths share of one step: computed once, not once a path.
struct shared_step {
  vec<double, 3> b, area;                          ///< sum sigma_i dW^i and sum A^ij [sigma_i, sigma_j]
  std::array<vec<double, 3>, 3> rotation, damped;  ///< of the noise; with half a dissipation before and after it
};

struct shared_noise {
  static constexpr bool shared = true;
  shared_step step;
  std::array<vec<double, 3>, 3> ito{};

  template <class S>
  vec<S, 3> noise(const vec<S, 3>&) const {
    return {{S(step.b[0]), S(step.b[1]), S(step.b[2])}};
  }
  template <class S>
  vec<S, 3> area_noise(const vec<S, 3>&) const {
    return {{S(step.area[0]), S(step.area[1]), S(step.area[2])}};
  }
  template <class S>
  vec<S, 3> ito_drift(const vec<S, 3>& mu) const {
    return diagonal_noise{.ito = ito}.ito_drift(mu);
  }
};

}  // namespace polhode
