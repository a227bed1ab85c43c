// SPDX-License-Identifier: Apache-2.0
// The error of averages that are combined over step sizes.
#pragma once

#include <functional>

#include "experiments/laws/extrapolation.hpp"
#include "experiments/laws/law_errors.hpp"

namespace polhode {

/// Of one scheme at dt, to a share of each error; finer: at the times of dt * finer (weak_law::error).
using law_error_at = std::function<law_error(double dt, double relative, std::int64_t finer)>;

/// What is left after the leading powers have dropped out is small against the errors themselves, so these are resolved
/// ever finer, until it is known to the share `relative` of the largest or to `accuracy`, in units of the observables'
/// sizes, or until rounding forbids more. The times are those of dt.
law_error combined_error(const extrapolation&, double dt, double relative, double accuracy, const law_error_at&);

}  // namespace polhode
