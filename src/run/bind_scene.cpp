// SPDX-License-Identifier: Apache-2.0
#include "run/bind_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "reports/model/errors.hpp"

namespace polhode {
namespace {

// Beyond it, or its inverse, powers that the laboratory forms leave what a double can hold.
constexpr double most = 1e50;
// Of rates: beside one that is faster a slower one is lost in rounding. Of noise what moves a path, its square root.
constexpr double widest = 1e13;

bool in_scale(double x) { return x == 0 || (std::fabs(x) <= most && std::fabs(x) >= 1 / most); }

}  // namespace

void require_scale(const subject& bound) {
  const auto& s = bound.scene;
  const auto require = [&](std::string_view what, double x) {
    if (!in_scale(x))
      throw input_error(fmt::format(
          "scene {}: {} = {:g}: too large or too small for double precision here; accepted: 0, or {:g} to {:g} "
          "in size; choose other units",
          s.name, what, x, 1 / most, most));
  };
  for (const auto& p : s.parameters)
    for (const auto& row : p.rows)
      for (const double x : row) require(p.name, x);
  for (const double x : s.momentum) require("momentum", x);
  require("the fastest rate of its equation", bound.offers->rates.fastest());
  require("its energy", bound.model->energy(s.momentum));
  const auto& rates = bound.offers->rates;
  const double fastest = rates.fastest();
  for (const double slow : {rates.motion, rates.dissipation, std::sqrt(rates.noise * fastest)})
    if (slow > 0 && fastest > widest * slow)
      throw input_error(
          fmt::format("scene {}: motion, dissipation and noise have rates of {:.2g}, {:.2g} and {:.2g}, and "
                      "the slower are lost in rounding; accepted: 0, or rates within {:g} of each other",
                      s.name, rates.motion, rates.dissipation, rates.noise, widest));
}

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
