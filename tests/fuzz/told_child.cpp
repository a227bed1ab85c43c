// SPDX-License-Identifier: Apache-2.0
// In place of src/foreign/child.cpp, for dialogues at the rate of a fuzzer: nothing is started. The first of the words
// is what the program writes, the second what it writes on its standard error stream; it reads whatever it is told.
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include "foreign/child.hpp"
#include "fuzz.hpp"

namespace polhode::foreign {
namespace {

int stream_of(const std::string& text) {
  const int file = ::memfd_create("stream", MFD_CLOEXEC);
  const auto size = static_cast<ssize_t>(text.size());
  fuzz::demand(file >= 0 && ::pwrite(file, text.data(), text.size(), 0) == size, "a file in memory can be written");
  return file;
}

}  // namespace

child::child(const std::vector<std::string>& words)
    : in_(::open("/dev/null", O_WRONLY | O_CLOEXEC)), out_(stream_of(words.at(0))), err_(stream_of(words.at(1))) {}

child::~child() {
  for (const int end : {in_, out_, err_}) ::close(end);
}

std::optional<std::string> child::end() {
  static_cast<void>(process_);  // there is none
  return "ended with exit code 0";
}

std::vector<std::string> words_of(const std::string& command) { return {command}; }

void kill_children() {}

}  // namespace polhode::foreign
