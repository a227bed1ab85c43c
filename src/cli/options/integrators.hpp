// SPDX-License-Identifier: Apache-2.0
// What a command works on: its scene, and integrators from elsewhere (--with, --deadline).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/parser.hpp"
#include "foreign/foreign_scheme.hpp"
#include "scene/scene.hpp"

namespace polhode::cli {

/// As given.
struct integrator_arguments {
  std::vector<std::string> with;
  std::optional<std::string> deadline;
};

void add_integrators(CLI::App&, integrator_arguments&);

/// Throws input_error of one line.
foreign::foreign_schemes opened_integrators(const integrator_arguments&);

/// Loads it as load_scene does; a remark of its system goes to standard error, one line.
scene opened_scene(const std::string& name_or_path);

}  // namespace polhode::cli
