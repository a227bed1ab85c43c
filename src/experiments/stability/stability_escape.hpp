// SPDX-License-Identifier: Apache-2.0
// When do the moments of a scheme that leaves the sphere explode?
//
// Its drift is cubic and its noise normal, so that in exact arithmetic some paths run off at every dt and moments of
// all paths do not exist (Hutzenthaler, Jentzen, Kloeden, Proc. R. Soc. A 467 (2011) 1563); what depends on dt is how
// rare they are. Two numbers tell, neither sampled: from which radius on a path runs off even without noise, and a
// bound on the share of paths that leave the shell within the horizon (transfer.hpp, taken_back).
#pragma once

#include "experiments/stability/stability_case.hpp"

namespace polhode {

/// The least |Pi|, in units of the case's, from which the step without noise runs off: some direction grows a
/// millionfold within 32 steps. At least 1, to a hundredth; infinite where none does up to 1e6.
double escape_radius(const stability_case&, const scheme_entry&, double dt);

/// Both numbers over dt, from 1/rate down by halves, at most ten, until at most a millionth of the paths leaves the
/// shell, and that dt; without noise the radius alone. Of schemes that keep the sphere nothing.
void report_escape(const stability_case&, const scheme_entry&, recorder&);

}  // namespace polhode
