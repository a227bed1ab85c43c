// SPDX-License-Identifier: Apache-2.0
#include "reproduction/reproduce.hpp"

#include <algorithm>

#include "reproduction/cases.hpp"
#include "scene/nearest.hpp"

namespace polhode {

const std::vector<reproduction_case>& reproduction_cases() {
  static const std::vector<reproduction_case> all{
      {"uniaxial_spin", "Law of a spin with an easy axis (MicroMagnetic.jl)", uniaxial_spin},
      {"two_spins", "Energy of two coupled spins (Sunny.jl)", two_spins},
      {"magpy_convergence", "Strong orders of Heun and of the implicit midpoint rule (magpy)", magpy_convergence},
      {"sds_on_s2", "Weak geometric schemes on the sphere (Gogoi, Panda, Hazra, Pakrashi)", sds_on_s2},
      {"lie_poisson_midpoint", "Orders of an implicit midpoint rule (Ephrati, Jansson, Lang, Luesink)",
       lie_poisson_midpoint},
      {"paper", "Random attractor of the rigid body (Arnaudon, De Castro, Holm)", attractor_of_the_paper}};
  return all;
}

std::vector<std::size_t> chosen_reproductions(const std::vector<std::string>& names) {
  std::vector<std::string> known;
  for (const auto& c : reproduction_cases()) known.emplace_back(c.name);
  std::vector<std::size_t> out;
  for (const auto& name : names)
    if (const auto i = choose("CASE", name, known); std::ranges::find(out, i) == out.end()) out.push_back(i);
  if (names.empty())
    for (std::size_t i = 0; i < known.size(); ++i) out.push_back(i);
  return out;
}

std::vector<report::reproduction> reproduce(const std::vector<std::size_t>& cases, const reproduce_options& options,
                                            const progress_sink& progress) {
  std::vector<report::reproduction> out;
  for (const auto i : cases) {
    const auto& c = reproduction_cases()[i];
    if (progress) progress(static_cast<double>(out.size()) / static_cast<double>(cases.size()), c.name);
    auto found = c.run(options);
    found.name = c.name;
    found.title = c.title;
    out.push_back(std::move(found));
  }
  return out;
}

}  // namespace polhode
