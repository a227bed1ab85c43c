// SPDX-License-Identifier: Apache-2.0
// What `polhode verify` is asked for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/options/integrators.hpp"
#include "cli/options/parser.hpp"
#include "run/verify.hpp"

namespace polhode::cli {

/// As given: checked in one place, so that every fault reads alike.
struct verify_arguments {
  std::vector<std::string> scenes;
  std::string schemes, experiments, effort = "standard", out = "report", threads, seed = "1", isa = "auto",
                                    generator = "philox", format = "text", progress = "auto";
  integrator_arguments integrators;
  std::optional<std::string> baseline, save_baseline, budget;
  bool fresh = false, no_cache = false, quiet = false, latex = false, profile = false, forecast = false;
};

/// Defaults, and the options that change them.
void add_verify_arguments(CLI::App&, verify_arguments&);

// Throw input_error of one line.
verify_options checked_options(const verify_arguments&);
std::vector<scene> checked_scenes(const verify_arguments&);

}  // namespace polhode::cli
