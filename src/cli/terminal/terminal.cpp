// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal/terminal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <string>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

namespace polhode::cli {
namespace {

constexpr std::size_t narrowest = 20, widest = 1000, usual = 80;

/// 0 or the errno that ended it.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const auto count = ::write(descriptor, text.data(), text.size());
    if (count < 0 && errno == EAGAIN) {  // a pipe that somebody made non-blocking
      pollfd room{descriptor, POLLOUT, 0};
      ::poll(&room, 1, -1);
      continue;
    }
    if (count < 0 && errno != EINTR) return errno;
    if (count < 0) continue;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return 0;
}

std::size_t columns_of_environment() {
  const char* text = std::getenv("COLUMNS");
  std::size_t columns = 0;
  if (text != nullptr) std::from_chars(text, text + std::strlen(text), columns);
  return columns;
}

}  // namespace

void hold_standard_streams() {
  for (int descriptor = 0; descriptor <= 2; ++descriptor) {
    if (::fcntl(descriptor, F_GETFD) >= 0 || errno != EBADF) continue;
    // Opened so that using it still fails: not for reading as input, not for writing as output.
    if (::open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY) < 0) return;
  }
}

std::size_t terminal_width(int descriptor) {
  std::size_t columns = columns_of_environment();
  winsize size{};
  if (columns == 0 && ::ioctl(descriptor, TIOCGWINSZ, &size) == 0) columns = size.ws_col;
  return columns == 0 ? usual : std::clamp(columns, narrowest, widest);
}

void print(std::string_view text) {
  const int fault = write_all(STDOUT_FILENO, text);
  if (fault != 0 && fault != EPIPE)
    throw output_error(fmt::format("standard output cannot be written ({})", std::strerror(fault)));
}

void print_error(std::string_view text) noexcept {
  try {
    write_all(STDERR_FILENO, fmt::format("polhode: {}\n", one_line(text, 2000)));
  } catch (...) {
    write_all(STDERR_FILENO, "polhode: out of memory\n");
  }
}

void print_aside(std::string_view text) noexcept { write_all(STDERR_FILENO, text); }

}  // namespace polhode::cli
