#include "run/machine_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "ensemble/noise/normal_block.hpp"
#include "platform/isa.hpp"
#include "reports/model/errors.hpp"

namespace polhode {

void apply_isa(const std::string& wanted) {
  if (wanted == "auto") return;
  const auto usable = usable_isas();
  const auto level = isa_named(wanted);
  if (!level || std::ranges::find(usable, *level) == usable.end()) {
    std::vector<std::string_view> names{"auto"};
    for (const isa i : usable) names.push_back(name_of(i));
    throw input_error(fmt::format("--isa: \"{}\" is not to be had here; accepted: {}", wanted, fmt::join(names, ", ")));
  }
  choose_isa(*level);
}

noise_generator generator_named(const std::string& name) {
  if (name == "philox") return noise_generator::philox;
  if (name == "ars" && ars_usable()) return noise_generator::ars;
  throw input_error(fmt::format("--generator: \"{}\" is {}; accepted: philox{}", name,
                                name == "ars" ? "not to be had here: the processor has no AES" : "not known",
                                ars_usable() ? ", ars" : ""));
}

}  // namespace polhode
