// SPDX-License-Identifier: Apache-2.0
// The commands. Each registers itself with the parser.
#pragma once

#include "cli/options/parser.hpp"

namespace polhode::cli {

command add_verify(CLI::App&);
command add_simulate(CLI::App&);
command add_reference(CLI::App&);
command add_select(CLI::App&);
command add_compare(CLI::App&);
command add_reproduce(CLI::App&);
command add_check(CLI::App&);
command add_list(CLI::App&);

}  // namespace polhode::cli
