// SPDX-License-Identifier: Apache-2.0
// Values given on the command line, checked. Every fault is an input_error of one line.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace polhode::cli {

/// Of an argument in an error: quoted, in one line, not too long.
std::string shown(std::string_view);

/// "all processors", within what is accepted.
std::string default_threads();
int threads_option(std::string_view text);
/// A finite number above zero, or from zero on.
double positive_option(std::string_view option, std::string_view text);
double nonnegative_option(std::string_view option, std::string_view text);
std::uint64_t integer_option(std::string_view option, std::string_view text, std::uint64_t low, std::uint64_t high);
/// "a,b" -> {a, b}, each once.
std::vector<std::string> list_option(std::string_view option, std::string_view text);

enum class format { text, json };
format format_option(std::string_view text);

}  // namespace polhode::cli
