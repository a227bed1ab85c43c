// SPDX-License-Identifier: Apache-2.0
// The scenes of the cases, and what is run on them.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "problem/subject.hpp"
#include "run/bind_scene.hpp"

namespace polhode {

/// Of the text of a scene file.
scene scene_of(std::string_view text);

const scheme_entry& scheme_of(const subject&, std::string_view name);

/// One number a path and level, [level][path].
using path_values = std::vector<std::vector<double>>;

/// Least-squares slope of log2(mean of a level) over log2(dt).
double slope_of_means(std::span<const double> means, std::span<const double> dt);

}  // namespace polhode
