// SPDX-License-Identifier: Apache-2.0
#include "cli/missing_memory.hpp"

#include <unistd.h>

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <new>

#include "cli/terminal/progress.hpp"
#include "cli/terminal/signals.hpp"
#include "cli/terminal/terminal.hpp"
#include "reports/writers/disk.hpp"

namespace polhode::cli {
namespace {

std::atomic<int> exit_code = 0;  // 0: exceptions are passed on
std::array<char, 80> line{};     // written beforehand

/// By the first thread that comes here; others wait for the end.
[[noreturn]] void end() {
  static std::atomic_flag begun;
  while (begun.test_and_set()) ::pause();
  clear_progress();
  report::disk::remove_last_staged();
  print_aside(line.data());
  end_at_once(exit_code);
}

void* there(void* block, bool asked) {
  if (block == nullptr && asked && exit_code != 0) end();
  return block;
}

}  // namespace

void end_where_memory_ends(int code, std::string_view signature) {
  fmt::format_to_n(line.begin(), line.size() - 1, "polhode: {}out of memory\n", signature);
  exit_code = code;
  std::set_new_handler(end);
}

}  // namespace polhode::cli

// Those of Eigen, which does not ask operator new: the linker puts these in their place (--wrap, CMakeLists.txt).
// NOLINTBEGIN(bugprone-reserved-identifier): names that the linker gives
extern "C" {
void* __real_malloc(std::size_t);
void* __real_calloc(std::size_t, std::size_t);
void* __real_realloc(void*, std::size_t);
void* __wrap_malloc(std::size_t size) { return polhode::cli::there(__real_malloc(size), size > 0); }
void* __wrap_calloc(std::size_t count, std::size_t size) {
  return polhode::cli::there(__real_calloc(count, size), count > 0 && size > 0);
}
void* __wrap_realloc(void* block, std::size_t size) {
  return polhode::cli::there(__real_realloc(block, size), size > 0);
}
}
// NOLINTEND(bugprone-reserved-identifier)
