// SPDX-License-Identifier: Apache-2.0
// What means along the circles of constant energy of a rigid body are made of.
#pragma once

namespace polhode {

/// Integrals over a quarter turn of 1, sin^2 and sin^4 over sqrt(1 - m sin^2).
struct elliptic_moments {
  double one, sin2, sin4;
};

/// left = 1 - m, given as well where m is next to 1; 0 <= m < 1. Good to 1e-12: K and (K - E) / m by DLMF 19.25.1, and
/// by parts 3 m S_4 = 2 (1 + m) S_2 - S_0; where m is small the series of S_4.
elliptic_moments elliptic_moments_of(double m, double left);

}  // namespace polhode
