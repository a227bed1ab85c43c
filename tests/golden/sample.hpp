// SPDX-License-Identifier: Apache-2.0
// A small result made by hand that holds everything a writer can stumble over.
#pragma once

#include "reports/model/results.hpp"

namespace polhode::golden {

/// Three schemes (one with a hostile name), all four verdicts, missing and non-finite numbers, a skipped experiment.
report::results sample();

/// The same under a harmless name.
report::results sample_named(const char* scene);

}  // namespace polhode::golden
