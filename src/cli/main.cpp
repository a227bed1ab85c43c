// SPDX-License-Identifier: Apache-2.0
// polhode: runs one command, turns every outcome into an exit code.
#include <new>

#include "cli/commands.hpp"
#include "cli/freed_memory.hpp"
#include "cli/terminal/signals.hpp"
#include "cli/terminal/terminal.hpp"
#include "reports/model/errors.hpp"

namespace polhode::cli {
namespace {

constexpr int bad_input = 2, cannot_run = 4;

}  // namespace

int guarded(int argc, char** argv) noexcept {
  try {
    return run_command(argc, argv, [](CLI::App& app) {
      return std::vector<command>{add_verify(app),  add_simulate(app),  add_reference(app), add_select(app),
                                  add_compare(app), add_reproduce(app), add_check(app),     add_list(app)};
    });
  } catch (const input_error& fault) {
    print_error(fault.what());
    return bad_input;
  } catch (const std::bad_alloc&) {
    print_error("out of memory");
  } catch (const std::exception& fault) {
    print_error(fault.what());
  } catch (...) {
    print_error("stopped by an unknown fault");
  }
  return cannot_run;
}

}  // namespace polhode::cli

int main(int argc, char** argv) {
  polhode::cli::keep_freed_memory();
  polhode::cli::hold_standard_streams();
  polhode::cli::install_signal_handlers();
  return polhode::cli::guarded(argc, argv);
}
