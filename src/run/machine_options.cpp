// SPDX-License-Identifier: Apache-2.0
#include "run/machine_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "ensemble/noise/normal_block.hpp"
#include "platform/isa.hpp"
#include "scene/nearest.hpp"

namespace polhode {

void apply_isa(const std::string& wanted) {
  const auto usable = usable_isas();
  std::vector<std::string> names{"auto"};
  for (const isa i : usable) names.emplace_back(name_of(i));
  if (isa_named(wanted) && std::ranges::find(names, wanted) == names.end())
    refuse("--isa", wanted, fmt::format("not to be had here; accepted: {}", fmt::join(names, ", ")));
  if (const auto chosen = choose("--isa", wanted, names); chosen > 0) choose_isa(usable[chosen - 1]);
}

noise_generator generator_named(const std::string& name) {
  std::vector<std::string> names{"philox"};
  if (ars_usable())
    names.emplace_back("ars");
  else if (name == "ars")
    refuse("--generator", name, "not to be had here: the processor has no AES; accepted: philox");
  return choose("--generator", name, names) == 0 ? noise_generator::philox : noise_generator::ars;
}

}  // namespace polhode
