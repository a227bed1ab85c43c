// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal/terminal.hpp"
#include "cli/together.hpp"

namespace polhode::cli {

together::together(int* /*argc*/, char*** /*argv*/) {}
together::~together() = default;
const ranks* others() { return nullptr; }
bool speaks() { return true; }
int processes_here() { return 1; }
void fail(std::string_view fault, int /*code*/) { print_error(fault); }

}  // namespace polhode::cli
