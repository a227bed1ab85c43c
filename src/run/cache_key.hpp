// SPDX-License-Identifier: Apache-2.0
// The key of what is kept: everything on which what one experiment says of one scheme depends, as text; or a
// simulation.
#pragma once

#include <string>
#include <string_view>

#include "ensemble/simulation.hpp"
#include "experiments/common/experiment.hpp"
#include "scene/scene.hpp"

namespace polhode {

/// The values of the scene but its name, effort, seed, instruction set, processor, and the running program itself; not
/// the number of threads, nor the other schemes. Empty where the program cannot be identified: keep nothing then.
/// The scheme is known by its name, so a key is good for subjects of bind_scene only.
std::string cache_key(const context&, std::string_view experiment, std::string_view scheme);

/// The same of a simulation: besides the scene and what runs it, all of the plan but its threads.
std::string simulation_key(const scene&, std::string_view scheme, double dt, const simulation_plan&);

}  // namespace polhode
