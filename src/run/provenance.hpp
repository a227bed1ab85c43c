// SPDX-License-Identifier: Apache-2.0
// Where a result comes from, as far as the build and the machine know it.
#pragma once

#include "reports/model/results.hpp"

namespace polhode {

/// Version, commit, compiler, flags, CPU and the time of the call; what a run adds is left as it is by default.
report::provenance build_provenance();

}  // namespace polhode
