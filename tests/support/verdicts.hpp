// SPDX-License-Identifier: Apache-2.0
// What tests ask of a subject and of a report by name; a name that is not there is an error of the test.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/common/noise_verdict.hpp"
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

inline verify_options quick_options(std::vector<std::string> experiments, std::vector<std::string> schemes = {},
                                    int threads = 2) {
  verify_options out;
  out.experiments = std::move(experiments);
  out.schemes = std::move(schemes);
  out.effort = effort::quick;
  out.threads = threads;
  return out;
}

/// What experiments report at effort quick.
inline report::results quick_results(const subject& s, std::vector<std::string> experiments) {
  return verify_subject(s, quick_options(std::move(experiments)));
}
inline report::results quick_results(const report::scene& s, std::vector<std::string> experiments,
                                     std::vector<std::string> schemes = {}, int threads = 2) {
  return verify(s, quick_options(std::move(experiments), std::move(schemes), threads));
}

/// What one part of an experiment, a function (context, results), reports at effort quick.
template <class Part>
report::results quick_report(const subject& s, const Part& part) {
  report::results out;
  part(context{s, effort::quick, 2}, out);
  return out;
}

/// One verdict on the noise, which holds, and the largest deviation of each part.
inline void expect_noise_of(const report::results& r, const std::vector<std::string>& parts) {
  int verdicts = 0;
  for (const auto& v : r.verdicts)
    if (v.scheme == noise_name) {
      ++verdicts;
      EXPECT_EQ(v.claim, noise_claim);
      EXPECT_EQ(v.kind, report::verdict_kind::holds) << v.reason;
    }
  EXPECT_EQ(verdicts, 1);
  std::vector<std::string> found;
  for (const auto& m : r.measurements)
    if (m.scheme == noise_name) found.push_back(m.observable.substr(0, m.observable.find(':')));
  EXPECT_EQ(found, parts);
}

}  // namespace polhode::test
