// SPDX-License-Identifier: Apache-2.0
// How a process introduces itself: docs/process-protocol.md.
#pragma once

#include <string>

#include "foreign/integrator.hpp"

namespace polhode::foreign {

inline constexpr int protocol_version = 1;

/// The line as a description, which comes `from` there. Throws input_error, which begins with `where`.
description read_greeting(const std::string& line, const std::string& where, const std::string& from);

}  // namespace polhode::foreign
