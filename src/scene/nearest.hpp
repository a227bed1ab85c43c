// SPDX-License-Identifier: Apache-2.0
// "Did you mean": the known name nearest to an unknown one; and how an option's value is refused.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace polhode {

/// The candidate with the least edit distance to `name`; empty if none is near: half of
/// a name of four characters may differ, of a longer one a quarter and one more.
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

/// "; did you mean 'heun'?", to be put behind an unknown name; empty if none is near.
std::string did_you_mean(std::string_view name, std::span<const std::string> candidates);

/// The same, and what there is: "; did you mean 'heun'?; accepted: heun, strang".
std::string accepted_instead(std::string_view name, std::span<const std::string> known);

/// Throws input_error: "--dt '0': accepted: a number above 0".
[[noreturn]] void refuse(std::string_view option, std::string_view value, std::string_view fault);

/// The place of the value in the list of those known; throws input_error where it has none.
std::size_t choose(std::string_view option, std::string_view value, std::span<const std::string> known);

}  // namespace polhode
