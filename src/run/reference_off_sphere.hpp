// SPDX-License-Identifier: Apache-2.0
// References of systems that live on no sphere of momentum, and what all references share in words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "run/reference.hpp"
#include "sphere/galerkin/reference_value.hpp"

namespace polhode {

inline constexpr const char* usual_observable = "energy";

[[noreturn]] void refuse_observable(const std::string& name, const std::vector<observable_entry>& accepted);
[[noreturn]] void refuse_scene(const scene&, const reference_answer&, std::string_view why);

/// scale: the size that the value is measured by, besides its own. Where not one digit is certain, words say more.
void take(const scene&, const reference_value& found, reference_answer& out, double scale = 0);

/// The means of a Gibbs law that the system knows, and expectations on a product of two spheres. Throws input_error for
/// what else is asked.
reference_answer reference_off_sphere(const subject&, const reference_options&);

}  // namespace polhode
