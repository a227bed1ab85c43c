// SPDX-License-Identifier: Apache-2.0
#include "cli/together.hpp"

namespace polhode::cli {

together::together(int* /*argc*/, char*** /*argv*/) {}
together::~together() = default;
const ranks* others() { return nullptr; }
bool speaks() { return true; }
int processes_here() { return 1; }
std::string signature() { return {}; }
void end_all(int /*code*/) {}

}  // namespace polhode::cli
