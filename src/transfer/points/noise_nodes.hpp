// SPDX-License-Identifier: Apache-2.0
// Product rules for the noise of one step.
#pragma once

#include <vector>

#include "ensemble/model.hpp"

namespace polhode {

/// Gauss-Hermite nodes a channel and an area. Areas are normals of variance dt^2/4 (ensemble/noise/paths.hpp).
struct noise_rule {
  int channel, area;
  bool operator==(const noise_rule&) const = default;
};

/// The noise of one step as one path of as many steps as there are nodes.
struct noise_nodes {
  double dt;
  std::vector<double> dw, area, weight;
  increment_view path() const { return {static_cast<int>(weight.size()), dw, area}; }
};

/// Nodes of negligible weight are left out; channels that are not drawn have the one node 0. Of three areas not all
/// products of nodes are taken. Two nodes each: the four of eight whose product of signs alternates from one node of
/// the increments to its neighbours, so that given the increments any two areas are independent, and the mean of the
/// product of all three is next to nothing. Three nodes each: fourteen of another rule that is exact to degree five as
/// well.
noise_nodes nodes_of(const model&, bool with_areas, double dt, const noise_rule&);

/// In sqrt(dt), how far far_nodes_of goes.
inline constexpr double farthest_noise = 8;

/// The same expectation with nodes far out: spheres of radius up to 8 sqrt(dt) in the space of the active channels (at
/// most three), ten in each 2 sqrt(dt), times directions; two nodes an area, of three areas as above.
/// For increments too rare for nodes_of: beyond 5 sqrt(dt) lie 1.5e-5 of those of three channels.
noise_nodes far_nodes_of(const model&, bool with_areas, double dt);

/// In sqrt(dt): what a step makes of increments longer than that is not judged. Of three channels 9e-7 are. A branch at
/// 5 sqrt(dt) must be seen: one that drops its noise loses 7e-5 of sigma, ten times the share below. What is left of a
/// smooth step lies another ten times below that: nothing but rounding on the sphere (1e-12 of three channels), and on
/// a shell the paths that one increment beyond 6 sqrt(dt) throws out of it.
inline constexpr double rare_noise = 5.5;

/// The share of sigma that a step loses which drops its noise beyond rare_noise: half that of the variance,
/// E[r^2; r > R] / E[r^2] = P(r' > R), r and r' the lengths of standard normal vectors of k and k + 2 components
/// (integration by parts). 6.6e-6 of three channels, 6e-7 of one.
double rare_share(int active_channels);

}  // namespace polhode
