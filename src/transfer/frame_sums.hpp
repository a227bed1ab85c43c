// SPDX-License-Identifier: Apache-2.0
// Sums over many mapped tangent frames of the functions of frame_basis.hpp, compiled once per instruction set.
#pragma once

#include "ensemble/kernel.hpp"
#include "platform/isa_entry.hpp"

namespace polhode {

inline constexpr int most_frame_degree = 16;  ///< operators on tangent directions are dear

/// Of each lane a state x and two tangents v, w at it, mapped by one step. With u = v cos(gamma) + w sin(gamma), for
/// each angle gamma:
///   sums[lane / 8][angle][j][lane % 8] += sum over nodes of weight F_j(u / |u|, x cross u / |..|, x / |x|)
///   growth[angle][lane]                += sum over nodes of weight log |u|.
struct frame_sums {
  int degree;                ///< <= most_frame_degree
  int m_step;                ///< 1, or 2: of even m alone
  const double* recurrence;  ///< transfer/basis/frame_basis.hpp
  int size;                  ///< how many functions that makes
  int angles;
  const double* turns;  ///< [angle]: cos(gamma), sin(gamma)
  int lanes;            ///< in use: the first ones
  int nodes;
  const double *weights, *states, *tangents;  ///< [node], [node][component][lane], [node][vector][component][lane]
  double *sums, *growth;
};

/// By the instruction set in force. A frame that is not finite makes its lane's sums so.
void add_frames(const frame_sums&);

}  // namespace polhode

POLHODE_DECLARE_ENTRIES(polhode_add_frames_, const polhode::frame_sums&);
