// SPDX-License-Identifier: Apache-2.0
#include "reports/model/results.hpp"

#include <algorithm>
#include <utility>

namespace polhode::report {

std::optional<double> measurement::at_coordinate(std::string_view name) const {
  const auto found = std::ranges::find(at, name, &coordinate::name);
  return found == at.end() ? std::nullopt : std::optional(found->value);
}

void measurement::set_over(coordinate c) {
  over = c.name;
  at.push_back(std::move(c));
}

}  // namespace polhode::report
