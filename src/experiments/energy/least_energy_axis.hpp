// Dissipation without noise takes a body to rotation about its axis of greatest inertia, which has the least energy; in
// a field to one of the wells of h.
#pragma once

#include "experiments/common/experiment.hpp"

namespace polhode {

/// Runs until every motion has died out and looks where it ended. Open where that takes too many steps; nothing where
/// the system does not live on a sphere.
void report_end(const subject&, const scheme_entry&, report::results&);

}  // namespace polhode
