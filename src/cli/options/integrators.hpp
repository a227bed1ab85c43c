// SPDX-License-Identifier: Apache-2.0
// The options --with and --deadline: integrators from elsewhere.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/parser.hpp"
#include "foreign/foreign_scheme.hpp"

namespace polhode::cli {

/// As given.
struct integrator_arguments {
  std::vector<std::string> with;
  std::optional<std::string> deadline;
};

void add_integrators(CLI::App&, integrator_arguments&);

/// Throws input_error of one line.
foreign::foreign_schemes opened_integrators(const integrator_arguments&);

}  // namespace polhode::cli
