// SPDX-License-Identifier: Apache-2.0
// Functions of the state by their names, of any system: the one place where a name becomes a function.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "problem/subject.hpp"

namespace polhode {

using state_function = std::function<double(std::span<const double> mu)>;

struct observable {
  std::string name;
  state_function value;
};

/// The system's own name of the k-th component, from 0 on; else mu_1, mu_2, ….
std::string component_name(const subject&, std::size_t k);

/// "energy"; a component by the system's own name (capabilities::components) or as mu_1, mu_2, …; its square, "pi1^2";
/// and on a sphere what named_observable knows besides. Nothing for another name.
std::optional<state_function> observable_of(const subject&, std::string_view name);

/// The energy, the components and their squares, under the system's own names; of a long state the first
/// `most_components`.
std::vector<observable> observables_of(const subject&, std::size_t most_components);

}  // namespace polhode
