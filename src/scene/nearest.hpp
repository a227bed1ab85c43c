// "Did you mean": the known name nearest to an unknown one.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace polhode {

/// The candidate with the least edit distance to `name`; empty if none is near (more than half of it differs).
std::string nearest_name(std::string_view name, std::span<const std::string> candidates);

/// "; did you mean 'heun'?", to be put behind an unknown name; empty if none is near.
std::string did_you_mean(std::string_view name, std::span<const std::string> candidates);

}  // namespace polhode
