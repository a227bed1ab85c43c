// SPDX-License-Identifier: Apache-2.0
// Where the processor time of a run went, as text.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "reports/model/results.hpp"

namespace polhode::cli {

/// A line an experiment, the costliest first: seconds, share of the run, and by what was worked on, the most first.
/// Empty without rows.
std::string profile_table(std::span<const report::profile_row>, std::size_t width);

}  // namespace polhode::cli
