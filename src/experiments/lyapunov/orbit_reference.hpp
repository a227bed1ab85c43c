// SPDX-License-Identifier: Apache-2.0
// The Lyapunov exponents of an equation that does not live on one sphere, sampled: they are what schemes are held to.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "experiments/common/experiment.hpp"
#include "experiments/common/noise_verdict.hpp"
#include "experiments/common/sequential.hpp"
#include "experiments/lyapunov/orbit_growth.hpp"

namespace polhode {

/// How exponents are sampled on an orbit.
struct orbit_frame {
  explicit orbit_frame(const context&);
  orbit_geometry geometry;
  orbit_start start;
  double dt;                 ///< 32, 64, 128 steps per fastest time scale, by effort
  double margin;             ///< how far an exponent may lie from that of the equation: as far as rate * dt / 3
  int paths;                 ///< of the equation, whole blocks; no scheme gets more
  std::int64_t most_chunks;  ///< of a path
  int vectors() const { return geometry.dimension(); }

  /// Whether this effort affords that many tangents; if not, the claim is left untried for these schemes.
  bool affordable(const context&, std::span<const scheme_entry>, std::string_view experiment, std::string_view claim,
                  report::results&) const;
};

/// What was seen of paths over the time in which they were observed. [path]
struct observed_rates {
  std::int64_t forgetting = 0, observed = 0;  ///< in chunks
  Eigen::MatrixXd rates;                      ///< [path][k]
  Eigen::MatrixXd first_third;                ///< the same over the first third of the time
  Eigen::VectorXd volume, divergence;         ///< zeros where nobody looked at them
  std::string fault = {};                     ///< why the start may not be forgotten; empty: it is

  observed_rates() = default;
  observed_rates(int paths, int vectors);
  void keep(int block, const orbit_rates&);
};

/// Of the equation driven by the piecewise linear path through the same increments as a scheme of that dt, its tangents
/// by neighbours: nothing of it is a scheme's. The time in which the start is forgotten is doubled until means over the
/// two spans that follow it, as long as it and twice as long, agree to the margin. The first `vectors` exponents; the
/// volume where these are all.
observed_rates observe_equation(const context&, const orbit_frame&, int vectors, noise_log&);

}  // namespace polhode
