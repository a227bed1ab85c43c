// SPDX-License-Identifier: Apache-2.0
// The rows of a result document, both ways: measurements, fits and verdicts. Included by writers only.
//
// Version 1 knew two coordinates, "dt" and "steps" under the name "abscissa", and wrote any other into a name:
// "theta=8" for an observable.
#pragma once

#include "reports/model/results.hpp"
#include "reports/writers/json_node.hpp"
#include "reports/writers/json_values.hpp"

namespace polhode::report {

json to_value(const measurement&);
json to_value(const fit&);
json to_value(const verdict&);

measurement measurement_from(const node&, int version);
/// `measured`: the document's, which say over what a fit of version 1 was taken.
fit fit_from(const node&, int version, const std::vector<measurement>& measured);
verdict verdict_from(const node&, int version);

}  // namespace polhode::report
