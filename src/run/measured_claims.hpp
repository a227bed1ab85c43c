// SPDX-License-Identifier: Apache-2.0
// Orders that an integrator from elsewhere does not claim are measured: a first run, under noise of its own, says what
// the claims would be, and the run proper then tells whether they would hold.
#pragma once

#include <string>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "foreign/foreign_scheme.hpp"
#include "reports/model/results.hpp"
#include "scene/scene.hpp"

namespace polhode {

/// Tries the scheme on the scene, then measures what it does not claim, this scene can tell and one of the experiments
/// (empty: all) rests on, and sets it as claimed.
void measure_claims(const scene&, const std::shared_ptr<foreign::foreign_scheme>&,
                    const std::vector<std::string>& experiments, int threads, std::uint64_t seed);

/// Verdicts on orders that were not claimed accuse nobody: what would be refuted or inconclusive is told as measured.
/// A wrong limit remains one: an integrator of this scene converges to its equation.
void excuse_unclaimed(const foreign::foreign_schemes&, noise_class, report::results&);

}  // namespace polhode
