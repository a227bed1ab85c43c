// SPDX-License-Identifier: Apache-2.0
// The options --isa and --generator of every command that computes.
#pragma once

#include <polhode/noise/address.hpp>
#include <string>

namespace polhode {

/// Chooses the instruction set of the inner loops for the whole program; "auto" leaves the choice as it is. Throws
/// input_error for one that is not to be had here.
void apply_isa(const std::string& wanted);

/// philox or ars; throws input_error for another name, and for ars where the processor has no AES.
noise_generator generator_named(const std::string&);

}  // namespace polhode
