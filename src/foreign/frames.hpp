// SPDX-License-Identifier: Apache-2.0
// The frames that a process and the laboratory exchange: docs/process-protocol.md.
#pragma once

#include <cstdint>
#include <string>

#include "foreign/dialogue.hpp"
#include "foreign/integrator.hpp"

namespace polhode::foreign {

/// The line with which a process begins. Throws failure.
std::string hear_greeting(dialogue&);

/// Throws failure, also where it refuses the scene.
void tell_scene(dialogue&, const std::string& json);

/// Throws failure.
void ask_for_steps(dialogue&, const problem&, const batch&);

}  // namespace polhode::foreign
