// SPDX-License-Identifier: Apache-2.0
#include "cli/terminal/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <cstdlib>

#include "cli/terminal/terminal.hpp"
#include "reports/model/text.hpp"

namespace polhode::cli {
namespace {

constexpr auto least_interval = std::chrono::milliseconds{100};
constexpr std::size_t longest_note = 200;
std::atomic<bool> on_screen = false;

bool can_rewrite_lines() {
  const char* term = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) == 1 && (term == nullptr || std::string_view{term} != "dumb");
}

/// Progress that cannot be shown is no reason to stop.
void write_once(std::string_view text) noexcept {
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace

progress_line::progress_line(bool wanted) : shown_{wanted && can_rewrite_lines()} {}

progress_line::~progress_line() { clear_progress(); }

void progress_line::show(double share, std::string_view what) {
  const auto now = clock::now();
  if (!shown_ || now < next_) return;
  next_ = now + least_interval;
  share = share > 0 ? std::fmin(share, 1) : 0;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  // The first moments say nothing about the rest.
  const bool known = share >= 0.01 && elapsed >= 1;
  const auto left = known ? fmt::format(", {} left", duration_text(elapsed * (1 - share) / share)) : "";
  const auto line = fmt::format("{:.0f} %{}: {}", std::floor(100 * share), left, what);
  on_screen = true;
  // The last column stays free: writing there makes some terminals break the line.
  write_once(fmt::format("\r{}\x1b[K", one_line(line, terminal_width(STDERR_FILENO) - 1)));
}

void progress_note(std::string_view what) { write_once(fmt::format("{}\n", one_line(what, longest_note))); }

std::string duration_text(double seconds) {
  if (!(seconds < 3.6e8)) return "ages";
  if (seconds < 9.95) return fmt::format("{:.1f} s", seconds);
  const auto s = std::llround(seconds);
  if (s < 60) return fmt::format("{} s", s);
  return s < 3600 ? fmt::format("{} min {} s", s / 60, s % 60) : fmt::format("{} h {} min", s / 3600, s % 3600 / 60);
}

void clear_progress() noexcept {
  if (on_screen.exchange(false)) write_once("\r\x1b[K");
}

}  // namespace polhode::cli
