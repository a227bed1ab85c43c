// SPDX-License-Identifier: Apache-2.0
// Dissipation without noise takes a free body to rotation about the axis of least energy; in a field to one of the
// wells of h.
#pragma once

#include "experiments/common/recorder.hpp"
#include "problem/subject.hpp"

namespace polhode {

/// Runs until every motion has died out and looks where it ended. Open where that takes too many steps; nothing where
/// the system does not live on a sphere.
void report_end(const subject&, const scheme_entry&, recorder&);

}  // namespace polhode
