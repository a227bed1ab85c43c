#include "systems/systems.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace polhode {

const std::vector<system_entry>& systems() {
  static const std::vector<system_entry> all{{"rigid_body",
                                              "Dissipative stochastic rigid body on so(3)*, one Casimir |Pi|", 3,
                                              "inertia / time", rigid_body_parameters(), bind_rigid_body}};
  return all;
}

parameter_rule momentum_rule(const system_entry& of) {
  const std::size_t size = of.dimension;
  return {.name = "momentum",
          .shape = report::shape::vector,
          .unit = std::string(of.unit),
          .accepts = fmt::format("{} finite numbers, not all zero", in_words(size)),
          .meaning = "initial momentum",
          .read = [size](const report::number_rows& given, report::shape s) -> std::optional<report::number_rows> {
            const bool is_state = s == report::shape::vector && given[0].size() == size &&
                                  std::ranges::any_of(given[0], [](double x) { return x != 0; });
            return is_state ? std::optional(given) : std::nullopt;
          }};
}

const system_entry* find_system(std::string_view name) {
  const auto found = std::ranges::find(systems(), name, &system_entry::name);
  return found == systems().end() ? nullptr : &*found;
}

}  // namespace polhode
