// SPDX-License-Identifier: Apache-2.0
// Does a step commute with the half turns of a body about its principal axes?
//
// The equation of a body with diagonal inertia does, if its noise has the same law after them: with g = diag(1, -1, -1)
// and the like, Phi(g Pi, g dW) = g Phi(Pi, dW), g dW being dW with the signs of some channels changed. Then the
// operator of a step falls into four blocks, one for each pair of signs that functions take on under the half turns
// about axes 3 and 1, and is known from what it makes of a quarter of the sphere. Nothing of this is presumed of a
// scheme: it is tried out.
#pragma once

#include <functional>
#include <span>

#include "transfer/points/noise_nodes.hpp"
#include "transfer/points/turned_quadrature.hpp"

namespace polhode {

/// Advances a block of vectors, [vector][component][lane], by the step of one node.
using block_step = std::function<void(int node, std::span<double> vectors)>;

/// Whether that holds to 1e-13 of each vector for all lanes of these vectors at every node, for those signs of
/// the active channels by which it does at one; make(nodes) is the step by other nodes. False without being tried
/// for more than four channels.
bool commutes_with_half_turns(std::span<const double> vectors, const noise_nodes&, int active_channels,
                              const std::function<block_step(const noise_nodes&)>& make);

}  // namespace polhode
