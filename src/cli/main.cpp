// SPDX-License-Identifier: Apache-2.0
// polhode: runs one command, turns every outcome into an exit code.
#include <exception>
#include <new>
#include <string>
#include <string_view>

#include "cli/commands.hpp"
#include "cli/freed_memory.hpp"
#include "cli/missing_memory.hpp"
#include "cli/terminal/signals.hpp"
#include "cli/terminal/terminal.hpp"
#include "cli/together.hpp"
#include "reports/model/errors.hpp"

namespace polhode::cli {
namespace {

constexpr int bad_input = 2, cannot_run = 4;

int ended_by(std::string_view fault, int code) {
  fail(fault, code);
  return code;
}

}  // namespace

/// Where an exception cannot be passed on, as out of a destructor: memory, nearly always.
[[noreturn]] void end_by_fault() noexcept {
  try {
    if (const auto what = std::current_exception()) std::rethrow_exception(what);
    print_error("stopped by an unknown fault");
  } catch (const std::bad_alloc&) {
    print_error("out of memory");
  } catch (const std::exception& fault) {
    print_error(fault.what());
  } catch (...) {
    print_error("stopped by an unknown fault");
  }
  end_at_once(cannot_run);
}

int guarded(int argc, char** argv) noexcept {
  try {
    return run_command(argc, argv, [](CLI::App& app) {
      return std::vector<command>{add_verify(app),  add_simulate(app),  add_reference(app), add_select(app),
                                  add_compare(app), add_reproduce(app), add_check(app),     add_list(app)};
    });
  } catch (const input_error& fault) {
    return ended_by(fault.what(), bad_input);
  } catch (const std::bad_alloc&) {
    return ended_by("out of memory", cannot_run);
  } catch (const std::exception& fault) {
    return ended_by(fault.what(), cannot_run);
  } catch (...) {
    return ended_by("stopped by an unknown fault", cannot_run);
  }
}

}  // namespace polhode::cli

int main(int argc, char** argv) {
  std::set_terminate(polhode::cli::end_by_fault);
  polhode::cli::keep_freed_memory();
  polhode::cli::hold_standard_streams();
  const polhode::cli::together all(&argc, &argv);
  polhode::cli::end_where_memory_ends(polhode::cli::cannot_run, polhode::cli::signature());
  polhode::cli::install_signal_handlers();
  return polhode::cli::guarded(argc, argv);
}
