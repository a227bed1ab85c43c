// The systems that scenes can name, each bound to its schemes in a source of its own (templates are instantiated once).
#pragma once

#include <string_view>
#include <vector>

#include "problem/parameters.hpp"
#include "problem/subject.hpp"

namespace polhode {

/// What a scene may name as its `system`.
struct system_entry {
  std::string_view name, title;
  std::size_t dimension;  ///< of the momentum
  std::string_view unit;  ///< of the momentum
  std::vector<parameter_rule> parameters;
  subject (*bind)(const report::scene&);
};

const std::vector<system_entry>& systems();

/// The initial state, which every system has.
parameter_rule momentum_rule(const system_entry&);

/// Nothing where there is no such system.
const system_entry* find_system(std::string_view name);

std::vector<parameter_rule> rigid_body_parameters();
subject bind_rigid_body(const report::scene&);

}  // namespace polhode
