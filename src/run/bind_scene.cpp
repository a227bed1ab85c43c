// SPDX-License-Identifier: Apache-2.0
#include "run/bind_scene.hpp"

#include <fmt/format.h>

#include "reports/model/errors.hpp"

namespace polhode {

subject bind_scene(const scene& s, const foreign::foreign_schemes& foreign) {
  if (const auto* system = find_system(s.system)) return with_foreign(system->bind(s), foreign);
  throw input_error(fmt::format("scene {}: system = \"{}\" is not known", s.name, s.system));
}

report::scheme described(const scheme_entry& entry, const foreign::foreign_scheme* from) {
  const auto& i = entry.info;
  report::scheme s;
  s.name = i.name;
  s.title = i.title;
  s.source = i.source;
  s.calculus = i.calculus == calculus::ito ? "ito" : "stratonovich";
  s.implicit = i.implicit;
  s.areas = entry.needs_areas;
  s.strong_commuting = i.strong_order.commuting;
  s.strong_general = i.strong_order.general;
  s.weak_one_vector = i.weak_order.one_vector;
  s.weak_isotropic = i.weak_order.isotropic;
  s.weak_general = i.weak_order.general;
  s.deterministic_order = i.deterministic_order;
  s.casimir_exact = i.casimir.exact;
  s.casimir_order = i.casimir.noisy_order;
  if (from != nullptr) {
    s.from = from->about().from;
    s.takes = name_of(from->about().takes);
    s.measured = from->measured();
  }
  return s;
}

std::vector<report::scheme> list_schemes() {
  std::vector<report::scheme> out;
  for (const auto& entry : bind_scene(load_scene("paper")).schemes) out.push_back(described(entry));
  return out;
}

}  // namespace polhode
