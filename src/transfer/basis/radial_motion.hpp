// SPDX-License-Identifier: Apache-2.0
// How far from its sphere a scheme takes a path: the shell that is to hold it, and what leaves it.
#pragma once

#include "problem/subject.hpp"
#include "transfer/basis/shell_basis.hpp"
#include "transfer/basis/transfer_rule.hpp"

namespace polhode {

/// Wide enough for the radius of a path in `steps` steps; of no width for schemes that keep the sphere.
shell shell_of(const kernel&, const subject&, const noise_nodes&, std::int64_t steps, const basis_rule&);

/// A bound on the probability that a path of a scheme which leaves the sphere is taken back to the shell of that rule
/// within so many steps, in the law that the rule itself makes: for s > 0 exp(s log |Pi_n| - n psi(s)) is a
/// supermartingale while the path stays, psi(s) being the largest log E[exp(s change)] of a step inside (Doob 1953, VII
/// 3.2; Chernoff 1952). 0 on the sphere.
double taken_back(const subject&, const scheme_entry&, double dt, std::int64_t steps, const transfer_rule&);

}  // namespace polhode
