// SPDX-License-Identifier: Apache-2.0
// Recorded data against a scene, as a result with its provenance.
#pragma once

#include <filesystem>
#include <optional>

#include "recorded/check.hpp"
#include "scene/scene.hpp"

namespace polhode {

/// dt: of an array without times. Throws input_error on what is no recording of the scene's system.
checked_recording check(const scene&, const std::filesystem::path& data, std::optional<double> dt);

}  // namespace polhode
