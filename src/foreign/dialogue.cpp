// SPDX-License-Identifier: Apache-2.0
#include "foreign/dialogue.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>

#include "foreign/integrator.hpp"
#include "reports/model/text.hpp"

namespace polhode::foreign {
namespace {

using namespace std::chrono_literals;

constexpr auto grace = 1s;                  // from closed pipes to the end of a process
constexpr int most_reads = 64;              // of a stream that is written as fast as it is read
constexpr std::size_t kept_errors = 4096;   // bytes
constexpr std::size_t shown_columns = 240;  // of its last words
constexpr int shown_lines = 3;

int milliseconds(std::chrono::steady_clock::duration d) {
  const auto whole = std::chrono::ceil<std::chrono::milliseconds>(d).count();
  return static_cast<int>(std::clamp<std::int64_t>(whole, 0, INT_MAX));
}

/// The last lines that are not blank, as one.
std::string last_words(std::string_view text) {
  std::string out;
  for (int lines = 0; lines < shown_lines && !text.empty();) {
    const auto from = text.find_last_of('\n') + 1;  // npos + 1 = 0
    const auto line = one_line(text.substr(from), shown_columns);
    text = text.substr(0, from == 0 ? 0 : from - 1);
    if (line.empty()) continue;
    out = out.empty() ? line : line + " / " + out;
    ++lines;
  }
  return one_line(out, shown_columns);
}

}  // namespace

dialogue::dialogue(const std::vector<std::string>& words, double deadline)
    : child_(words), deadline_(deadline), until_(clock::now() + std::chrono::ceil<clock::duration>(deadline_)) {}

void dialogue::say(std::span<const iovec> bytes) {
  until_ = clock::now() + std::chrono::ceil<clock::duration>(deadline_);
  unsaid_.assign(bytes.begin(), bytes.end());
  std::erase_if(unsaid_, [](const iovec& part) { return part.iov_len == 0; });
}

std::size_t dialogue::hear(std::span<std::byte> answer, std::size_t got, std::size_t wanted) {
  if (!unsaid_.empty()) write();
  while (got < wanted) {
    wait(got);
    const auto more = ::read(child_.out(), answer.data() + got, answer.size() - got);
    if (more == 0) fail_at_end(got);
    if (more > 0) got += static_cast<std::size_t>(more);
  }
  return got;
}

void dialogue::write() {
  const auto written = ::writev(child_.in(), unsaid_.data(), static_cast<int>(unsaid_.size()));
  if (written < 0 && errno == EPIPE) stop_talking();
  if (written <= 0) return;
  auto left = static_cast<std::size_t>(written);
  while (!unsaid_.empty() && left >= unsaid_.front().iov_len) {
    left -= unsaid_.front().iov_len;
    unsaid_.erase(unsaid_.begin());
  }
  if (left == 0) return;
  unsaid_.front().iov_base = static_cast<char*>(unsaid_.front().iov_base) + left;
  unsaid_.front().iov_len -= left;
}

/// It has closed its standard input: what it has written so far may still be an answer.
void dialogue::stop_talking() {
  reads_ = false;
  unsaid_.clear();
  until_ = std::min(until_, clock::now() + grace);
}

/// Until there is something to read, or the child has closed that pipe.
void dialogue::wait(std::size_t got) {
  for (;;) {
    std::array<pollfd, 3> ends{{{child_.out(), POLLIN, 0},
                                {complains_ ? child_.err() : -1, POLLIN, 0},
                                {reads_ ? child_.in() : -1, static_cast<short>(unsaid_.empty() ? 0 : POLLOUT), 0}}};
    const auto left = until_ - clock::now();
    if (left <= 0s) fail_at_deadline(got);
    if (::poll(ends.data(), ends.size(), milliseconds(left)) <= 0) continue;
    if (ends[1].revents != 0) complains_ = keep_errors();
    if ((ends[2].revents & (POLLERR | POLLHUP)) != 0)
      stop_talking();
    else if (ends[2].revents != 0)
      write();
    if (ends[0].revents != 0) return;
  }
}

/// What is there of the standard error stream; false at its end.
bool dialogue::keep_errors() {
  std::array<char, kept_errors> some;
  for (int i = 0; i < most_reads; ++i) {
    const auto got = ::read(child_.err(), some.data(), some.size());
    if (got == 0) return false;
    if (got < 0) return errno == EAGAIN || errno == EINTR;
    errors_.append(some.data(), static_cast<std::size_t>(got));
    if (errors_.size() > kept_errors) errors_.erase(0, errors_.size() - kept_errors);
  }
  return true;
}

std::string dialogue::overheard() {
  std::array<char, 256> some;
  pollfd end{child_.out(), POLLIN, 0};
  if (::poll(&end, 1, milliseconds(50ms)) <= 0) return {};
  const auto got = ::read(child_.out(), some.data(), some.size());
  return {some.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0))};
}

void dialogue::fail(const std::string& what) {
  keep_errors();
  const auto words = last_words(errors_);
  throw failure(words.empty() ? what : fmt::format("{}; its last words: {}", what, words));
}

void dialogue::fail_at_end(std::size_t got) {
  const auto patience = clock::now() + grace;
  auto how = child_.end();
  for (; !how && clock::now() < patience; how = child_.end()) {
    if (complains_) complains_ = keep_errors();
    ::usleep(1000);
  }
  fail(how.value_or("closed its standard output") + (got > 0 ? " in the middle of an answer" : " without an answer"));
}

void dialogue::fail_at_deadline(std::size_t got) {
  if (!reads_) fail(child_.end().value_or("closed its standard input") + " without an answer");
  int unread = 0;
  ::ioctl(child_.in(), FIONREAD, &unread);
  const auto time = fmt::format("within {:g} s", deadline_.count());
  if (unread > 0 || !unsaid_.empty()) fail(fmt::format("stopped reading: no answer {}", time));
  fail(fmt::format("{} {}", got > 0 ? "no complete answer" : "no answer", time));
}

}  // namespace polhode::foreign
