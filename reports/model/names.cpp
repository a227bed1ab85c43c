// SPDX-License-Identifier: Apache-2.0
#include "reports/model/names.hpp"

#include <algorithm>

namespace polhode::report {
namespace {

void add_once(std::vector<std::string>& names, const std::string& name) {
  if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
}

// Everything that carries the member, in the order in which a report shows it.
template <class Member>
void add_mentioned(std::vector<std::string>& names, const results& r, Member name_in) {
  for (const auto& row : r.verdicts) add_once(names, name_in(row));
  for (const auto& row : r.fits) add_once(names, name_in(row));
  for (const auto& row : r.measurements) add_once(names, name_in(row));
  for (const auto& row : r.skipped) add_once(names, name_in(row));
}

}  // namespace

std::vector<std::string> experiment_names(const results& r) {
  std::vector<std::string> names;
  for (const auto& one : r.experiments) add_once(names, one.name);
  add_mentioned(names, r, [](const auto& row) -> const std::string& { return row.experiment; });
  return names;
}

std::vector<std::string> scheme_names(const results& r) {
  std::vector<std::string> names;
  for (const auto& one : r.schemes) add_once(names, one.name);
  add_mentioned(names, r, [](const auto& row) -> const std::string& { return row.scheme; });
  return names;
}

}  // namespace polhode::report
