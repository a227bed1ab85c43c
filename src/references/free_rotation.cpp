// SPDX-License-Identifier: Apache-2.0
#include "references/free_rotation.hpp"

#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

// In the ordered frame I[0] <= I[1] <= I[2], with h2 = 2h and M2 = |Pi|^2. For M2 > h2 I[1] the motion circles axis 2:
//   Pi_0 = a0 cn(u), Pi_1 = a1 sn(u), Pi_2 = a2 dn(u);
// for M2 < h2 I[1] it circles axis 0, and the roles of 0 and 2 change.
struct orbit {
  int round, other;         // the axis circled, and the far one of the remaining two
  std::array<double, 3> a;  // amplitudes, > 0
  double rate, parameter;   // u = rate * t + u0, m = k^2
};

orbit orbit_of(const std::array<double, 3>& inertia, const std::array<double, 3>& pi) {
  // Differences of squares, each written so that it does not cancel.
  const auto sum = [&](int axis) {  // 2 h I_axis - |Pi|^2
    double s = 0;
    for (int k = 0; k < 3; ++k) s += pi[k] * pi[k] * (inertia[axis] - inertia[k]) / inertia[k];
    return s;
  };
  orbit o{};
  const bool high = sum(1) <= 0;  // |Pi|^2 >= 2 h I_1
  o.round = high ? 2 : 0;
  o.other = high ? 0 : 2;
  const double i_r = inertia[o.round], i_o = inertia[o.other], i_1 = inertia[1];
  const double from_r = std::fabs(sum(o.round)), from_o = std::fabs(sum(o.other));
  const double spread = std::fabs(i_r - i_o), near = std::fabs(i_r - i_1), far = std::fabs(i_1 - i_o);
  o.a[o.round] = std::sqrt(i_r * from_o / spread);
  o.a[o.other] = std::sqrt(i_o * from_r / spread);
  o.a[1] = std::sqrt(i_1 * from_r / near);
  o.rate = std::sqrt(near * from_o / (inertia[0] * inertia[1] * inertia[2]));
  o.parameter = far * from_r / (near * from_o);
  return o;
}

// Rotation about the third axis of a symmetric body: I[0] = I[1].
std::array<double, 3> symmetric_rotation(double i_equal, double i_axis, int axis, const std::array<double, 3>& pi,
                                         double t) {
  const int k = (axis + 1) % 3, l = (axis + 2) % 3;
  const double angle = t * pi[axis] * (1 / i_axis - 1 / i_equal);
  auto out = pi;
  out[k] = pi[k] * std::cos(angle) + pi[l] * std::sin(angle);
  out[l] = pi[l] * std::cos(angle) - pi[k] * std::sin(angle);
  return out;
}

std::array<double, 3> ordered_rotation(const std::array<double, 3>& inertia, const std::array<double, 3>& pi,
                                       double t) {
  const orbit o = orbit_of(inertia, pi);
  if (o.a[1] == 0 || o.rate == 0) return pi;  // on an axis: an equilibrium
  const double sign_round = pi[o.round] < 0 ? -1 : 1;
  // Phase: sn(u0) = Pi_1 / a1, cn(u0) = Pi_other / a_other up to one common sign choice; cn carries the sign of
  // Pi_other.
  const double s0 = pi[1] / o.a[1], c0 = pi[o.other] / o.a[o.other];
  // Direction: d(Pi_1)/dt = Pi_2 Pi_0 (1/I_0 - 1/I_2), of the sign of Pi_0 Pi_2 = sign_round * Pi_other.
  double sn = 0, cn = 0, dn = 0;
  if (o.parameter < 1) {
    const double u0 = gsl_sf_ellint_F(std::atan2(s0, c0), std::sqrt(o.parameter), GSL_PREC_DOUBLE);
    gsl_sf_elljac_e(u0 + sign_round * o.rate * t, o.parameter, &sn, &cn, &dn);
  } else {  // on the separatrix, where sn = tanh and cn keeps its sign
    const double sign_other = c0 < 0 ? -1 : 1;
    const double u = std::atanh(s0) + sign_round * sign_other * o.rate * t;
    sn = std::tanh(u);
    dn = 1 / std::cosh(u);
    cn = sign_other * dn;
  }
  std::array<double, 3> out{};
  out[o.round] = sign_round * o.a[o.round] * dn;
  out[o.other] = o.a[o.other] * cn;
  out[1] = o.a[1] * sn;
  return out;
}

}  // namespace

std::array<double, 3> free_rotation(const std::array<double, 3>& inertia, const std::array<double, 3>& pi0, double t) {
  for (int axis = 0; axis < 3; ++axis) {
    const int k = (axis + 1) % 3, l = (axis + 2) % 3;
    if (inertia[k] == inertia[l]) return symmetric_rotation(inertia[k], inertia[axis], axis, pi0, t);
  }
  // Sort the axes; an odd permutation reverses the sense of the cross product, that is of time's arrow: reflect one
  // axis.
  std::array<int, 3> order{0, 1, 2};
  std::ranges::sort(order, [&](int a, int b) { return inertia[a] < inertia[b]; });
  const bool odd = (order[1] - order[0] + 3) % 3 != 1;
  std::array<double, 3> i{}, p{};
  for (int k = 0; k < 3; ++k) {
    i[k] = inertia[order[k]];
    p[k] = pi0[order[k]];
  }
  if (odd) p[0] = -p[0];
  auto moved = ordered_rotation(i, p, t);
  if (odd) moved[0] = -moved[0];
  std::array<double, 3> out{};
  for (int k = 0; k < 3; ++k) out[order[k]] = moved[k];
  return out;
}

}  // namespace polhode
