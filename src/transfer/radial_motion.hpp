// How far from its sphere a scheme takes a path: the shell that is to hold it, and what leaves it
// (taken_back, transfer.hpp).
#pragma once

#include "transfer/transfer.hpp"

namespace polhode {

/// Wide enough for the radius of a path in `steps` steps; of no width for schemes that keep the sphere.
shell shell_of(const kernel&, const subject&, const noise_nodes&, std::int64_t steps, const basis_rule&);

}  // namespace polhode
