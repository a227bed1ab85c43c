// SPDX-License-Identifier: Apache-2.0
// The key of a cached result: everything on which what one experiment says of one scheme depends, as text.
#pragma once

#include <string>
#include <string_view>

#include "experiments/common/experiment.hpp"

namespace polhode {

/// The values of the scene but its name, effort, seed, instruction set, processor, and the running program itself; not
/// the number of threads, nor the other schemes. Empty where the program cannot be identified: keep nothing then.
/// The scheme is known by its name, so a key is good for subjects of bind_scene only.
std::string cache_key(const context&, std::string_view experiment, std::string_view scheme);

}  // namespace polhode
