// SPDX-License-Identifier: Apache-2.0
// Published figures of the field, run again: what the command reproduce calls.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/common/experiment.hpp"
#include "reports/model/reproduction.hpp"
#include "run/progress_sink.hpp"

namespace polhode {

struct reproduce_options {
  polhode::effort effort = effort::standard;  ///< how much is sampled; what is exact is the same by all
  int threads = 1;
  std::uint64_t seed = 1;
};

struct reproduction_case {
  std::string_view name, title;
  std::function<report::reproduction(const reproduce_options&)> run;
};

/// All of them, in the order in which they are listed.
const std::vector<reproduction_case>& reproduction_cases();

/// The places of these names in that list, each once; of none, of all. Throws input_error on an unknown one.
std::vector<std::size_t> chosen_reproductions(const std::vector<std::string>& names);

/// Runs those cases.
std::vector<report::reproduction> reproduce(const std::vector<std::size_t>& cases, const reproduce_options&,
                                            const progress_sink& = {});

}  // namespace polhode
