// SPDX-License-Identifier: Apache-2.0
// What is different about an experiment where integrators from elsewhere take part.
#pragma once

#include <vector>

#include "experiments/common/experiment.hpp"
#include "foreign/foreign_scheme.hpp"
#include "reports/model/results.hpp"
#include "run/ranks.hpp"

namespace polhode {

/// Some schemes of a subject, and the form of an experiment in which they can be asked.
struct part {
  polhode::subject subject;
  polhode::experiment experiment;
};

/// The parts of a run; a row in `skipped` for each scheme that the experiment cannot ask, and in `savings` for each of
/// which it asks less, as a step takes long. Schemes that draw random numbers of their own are sampled: for them the
/// exact laws of a sphere are references alone.
std::vector<part> parts_for(const experiment&, const subject&, const foreign::foreign_schemes&, report::results&);

/// Appends what a further part of an experiment says of its schemes; what it says of the scene the first has said.
void append_of_schemes(const subject& part, report::results more, report::results& out);

/// Of integrators that have failed in this experiment: all that it says of them gives way to one verdict with the
/// reason.
void report_failures(const experiment&, const subject&, const foreign::foreign_schemes&, report::results&);

/// What one process has found of an integrator, that it has failed or does not run here, all know: in the words of the
/// first that has any. Its claims are those that the first has measured. Null: this process is alone.
void agree(const foreign::foreign_schemes&, const ranks* among);

}  // namespace polhode
