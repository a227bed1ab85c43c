// SPDX-License-Identifier: Apache-2.0
// Integrators in programs of their own, which speak on their standard streams: docs/process-protocol.md.
#pragma once

#include <memory>
#include <string>

#include "foreign/integrator.hpp"

namespace polhode::foreign {

inline constexpr double usual_deadline = 60;  ///< seconds for an answer

/// The integrator of a command line. As many processes run as threads ask at a time. Throws input_error: it cannot be
/// started, or does not introduce itself within `deadline` seconds.
std::unique_ptr<integrator> open_process(const std::string& command, double deadline);

}  // namespace polhode::foreign
