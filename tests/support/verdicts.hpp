// SPDX-License-Identifier: Apache-2.0
// What tests ask of a subject and of a report by name; a name that is not there is an error of the test.
#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "run/verify.hpp"

namespace polhode::test {

inline const scheme_entry& scheme_of(const subject& s, std::string_view name) {
  const auto found = std::ranges::find(s.schemes, name, [](const scheme_entry& e) { return e.info.name; });
  if (found == s.schemes.end()) throw std::out_of_range("no scheme " + std::string(name));
  return *found;
}

/// The first one of this claim.
inline const report::verdict& verdict_of(const report::results& r, std::string_view claim) {
  const auto found = std::ranges::find(r.verdicts, claim, &report::verdict::claim);
  if (found == r.verdicts.end()) throw std::out_of_range("no verdict on \"" + std::string(claim) + '"');
  return *found;
}

/// At effort quick.
inline report::results quick_results(const subject& s, std::vector<std::string> experiments) {
  verify_options options;
  options.experiments = std::move(experiments);
  options.effort = effort::quick;
  options.threads = 2;
  return verify_subject(s, options);
}

}  // namespace polhode::test
