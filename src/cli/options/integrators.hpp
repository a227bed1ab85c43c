// The option --with: integrators from elsewhere.
#pragma once

#include <string>
#include <vector>

#include "cli/options/parser.hpp"
#include "foreign/foreign_scheme.hpp"

namespace polhode::cli {

void add_integrators(CLI::App&, std::vector<std::string>& given);

/// Throws input_error of one line.
foreign::foreign_schemes opened_integrators(const std::vector<std::string>& given);

}  // namespace polhode::cli
