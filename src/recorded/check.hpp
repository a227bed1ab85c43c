// SPDX-License-Identifier: Apache-2.0
// Do recorded states follow a scene's equation, whatever wrote them and whatever step it took inside?
#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include "problem/subject.hpp"
#include "recorded/followed_equation.hpp"
#include "recorded/recording.hpp"
#include "reports/model/results.hpp"

namespace polhode {

/// The experiment and the scheme under which reports show recorded data.
inline constexpr const char *recorded_experiment = "recorded", *recorded_scheme = "recorded data";

struct checked_recording {
  report::results results;  ///< without provenance and scene
  followed_equation equation;
};

/// Verdicts "casimir", "transition law", "energy law" and "stationary law" of the states in the file. Throws
/// input_error on what is no recording of the scene's system.
checked_recording check_recording(const subject&, const std::filesystem::path&, std::optional<double> dt);

}  // namespace polhode
