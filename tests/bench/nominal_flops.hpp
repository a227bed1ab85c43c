// SPDX-License-Identifier: Apache-2.0
// Floating-point operations of an algorithm, for the share of the peak.
#pragma once

#include <optional>
#include <string_view>

#include "ensemble/simulation.hpp"

namespace polhode::bench {

/// Nominal additions and multiplications of one path and step on the scene `paper`, a fused one counted as two: 1/I_2
/// taken from every 1/I, small-angle polynomials, Strang's halves joined and, with common noise, D N D as one matrix.
/// Normals are not counted. Fixed numbers, so that shares of the peak stay comparable from kernel to kernel; one that
/// shares more subexpressions executes fewer (isa/heun_by_hand.cpp: 48), so this is no count of what a kernel executes,
/// and a share can exceed what its FMA units really do.
inline std::optional<double> nominal_flops(std::string_view scheme, ensemble_noise noise) {
  struct row {
    std::string_view scheme;
    double none, common, independent;
  };
  for (const row& r : {row{"heun", 57, 60, 60}, row{"strang", 75, 85, 120}, row{"lie_heun", 118, 142, 142}})
    if (r.scheme == scheme)
      return noise == ensemble_noise::none ? r.none : noise == ensemble_noise::common ? r.common : r.independent;
  return std::nullopt;
}

}  // namespace polhode::bench
