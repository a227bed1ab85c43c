// SPDX-License-Identifier: Apache-2.0
// What the harnesses share: the input as text, and what may become of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string_view>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace polhode::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

/// Ends the program where that does not hold: the fuzzer keeps the input.
inline void demand(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "not so: %s\n", what);
  std::abort();
}

/// What is read, or nothing where it is refused, in one line. Any other exception ends the program.
template <class Fault = input_error, class Read>
auto taken(Read read) -> std::optional<decltype(read())> {
  try {
    return read();
  } catch (const Fault& fault) {
    demand(*fault.what() != '\0' && is_plain_text(fault.what()), "a refusal is one line of text");
    return std::nullopt;
  }
}

}  // namespace polhode::fuzz
