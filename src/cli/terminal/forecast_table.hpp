// SPDX-License-Identifier: Apache-2.0
// What a run is expected to cost, as text.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "run/verify.hpp"

namespace polhode::cli {

/// A line an experiment, the dearest first, and one of the whole on so many threads.
std::string forecast_table(std::string_view scene, std::span<const expected_cost>, int threads, std::size_t width);

/// "paper: about 12 min on 2 threads: gibbs 5 min, weak 4 min, ..."; empty where it is not long.
std::string long_run_note(std::string_view scene, std::span<const expected_cost>, int threads, std::size_t width);

}  // namespace polhode::cli
