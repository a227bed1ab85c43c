// SPDX-License-Identifier: Apache-2.0
// What a process writes before anything else.
#include "foreign/greeting.hpp"

#include "foreign/frames.hpp"
#include "fuzz.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace polhode;
  foreign::dialogue with({std::string(fuzz::text_of(data, size)), ""}, 5);
  const auto line = fuzz::taken<foreign::failure>([&] { return foreign::hear_greeting(with); });
  if (line) fuzz::taken([&] { return foreign::read_greeting(*line, "--with 'it'", "command it"); });
  return 0;
}
