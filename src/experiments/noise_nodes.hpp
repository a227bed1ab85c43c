// Product rules for the noise of one step.
#pragma once

#include <vector>

#include "ensemble/model.hpp"

namespace polhode {

/// Gauss-Hermite nodes a channel and an area. Areas are normals of variance dt^2/4 (ensemble/paths.hpp).
struct noise_rule {
  int channel, area;
};

/// The noise of one step as one path of as many steps as there are nodes.
struct noise_nodes {
  double dt;
  std::vector<double> dw, area, weight;
  increment_view path() const { return {dt, static_cast<int>(weight.size()), dw, area}; }
};

/// Nodes of negligible weight are left out; channels that are not drawn have the one node 0.
noise_nodes nodes_of(const model&, bool with_areas, double dt, const noise_rule&);

/// The same expectation with nodes far out: spheres of radius up to 8 sqrt(dt) in the space of the active channels (at
/// most three), three in each half of a sqrt(dt), times directions; two nodes an area. For increments too rare for
/// nodes_of: beyond 5 sqrt(dt) lie 1.5e-5 of those of three channels.
noise_nodes far_nodes_of(const model&, bool with_areas, double dt);

}  // namespace polhode
