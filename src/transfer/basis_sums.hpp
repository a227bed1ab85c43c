// SPDX-License-Identifier: Apache-2.0
// Sums over many states of a basis of functions of momentum, compiled once per instruction set.
#pragma once

#include "ensemble/kernel.hpp"
#include "platform/isa_entry.hpp"

namespace polhode {

inline constexpr int sum_lanes = 8;  ///< lanes that lie side by side in the sums: a multiple of every pack width
inline constexpr int most_radial = 16;
inline constexpr double most_outside = 1.5;  ///< radii beyond that many half widths of the shell are taken back to it

/// sums[lane / 8][(l^2 + l + m) radial + k][lane % 8] += sum over nodes of weight T_k(t) Y_lm(Pi / |Pi|),
/// t = (|Pi| - middle) / half, held to +- most_outside; l <= degree, k < radial <= most_radial.
struct basis_sums {
  int degree, radial;
  double middle, half;       ///< half > 0; of no account where radial = 1
  const double* recurrence;  ///< for each m: P_mm over sin^m, then for l = m … degree the factors of
                             ///< P_{l+1,m} = a z P_lm - b P_{l-1,m}; harmonics as in sphere/harmonics/harmonics.hpp
  int lanes;                 ///< in use: the first ones
  int nodes;
  const double *weights, *states;  ///< [node] and [node][component][lane]
  double* sums;
};

/// By the instruction set in force. A state that is not finite makes its lane's sums so.
void add_basis(const basis_sums&);

}  // namespace polhode

POLHODE_DECLARE_ENTRIES(polhode_add_basis_, const polhode::basis_sums&);
