// The option --isa of every command that computes.
#pragma once

#include <string>

namespace polhode {

/// Chooses the instruction set of the inner loops for the whole program; "auto" leaves the choice as it is. Throws
/// input_error for one that is not to be had here.
void apply_isa(const std::string& wanted);

}  // namespace polhode
