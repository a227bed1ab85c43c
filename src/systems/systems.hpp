// SPDX-License-Identifier: Apache-2.0
// The systems that scenes can name, each bound to its schemes in a source of its own (templates are instantiated once).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "problem/parameters.hpp"
#include "problem/subject.hpp"

namespace polhode {

/// What a scene may name as its `system`.
struct system_entry {
  std::string_view name;
  std::string title;
  std::size_t dimension;  ///< of the momentum; 0: a parameter decides
  std::string_view unit;  ///< of the momentum
  std::vector<parameter_rule> parameters;
  std::vector<observable_entry> observables;
  subject (*bind)(const report::scene&);
  capabilities (*offers)(const report::scene&);
  std::vector<parameter_rule> own_units = {};  ///< what a scene may give in place of `parameters`
  std::vector<report::parameter> (*from_own_units)(const report::scene& given) = nullptr;
  std::optional<parameter_rule> momentum = {};  ///< where not every vector that is not zero is a state
};

const std::vector<system_entry>& systems();

/// The initial state, which every system has.
parameter_rule momentum_rule(const system_entry&);

/// Nothing where there is no such system.
const system_entry* find_system(std::string_view name);

/// What the system that the scene names offers there; nothing where it names none.
std::shared_ptr<const capabilities> offers_of(const report::scene&);

}  // namespace polhode
