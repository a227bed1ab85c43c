// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "cli/terminal/terminal.hpp"
#include "cli/together.hpp"

namespace polhode::cli {
namespace {

/// What the environment says, or nothing.
std::string_view told(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// By the first of them, where a launcher has started several: of Open MPI, of MPICH and its heirs, of Slurm.
void say_that_none_shares() {
  for (const auto& [count, number] : {std::pair{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"},
                                      {"PMI_SIZE", "PMI_RANK"},
                                      {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID"}})
    if (const auto processes = told(count); !processes.empty() && processes != "1" && told(number) == "0")
      return print_error(
          fmt::format("note: one of {} processes that do all of the work each; polhode-mpi would share it", processes));
}

}  // namespace

together::together(int* /*argc*/, char*** /*argv*/) { say_that_none_shares(); }
together::~together() = default;
const ranks* others() { return nullptr; }
bool speaks() { return true; }
int processes_here() { return 1; }
std::string signature() { return ""; }
void fail(std::string_view fault, int /*code*/) { print_error(fault); }

}  // namespace polhode::cli
