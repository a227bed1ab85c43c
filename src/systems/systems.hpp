// The systems that scenes can name, each bound to its schemes in a source of its own (templates are instantiated once).
#pragma once

#include <span>
#include <string_view>

#include "problem/subject.hpp"

namespace polhode {

struct system_entry {
  std::string_view name, title;
  subject (*bind)(const report::scene&);
};

std::span<const system_entry> systems();

subject bind_rigid_body(const report::scene&);

}  // namespace polhode
