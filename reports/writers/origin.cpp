// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/origin.hpp"

#include <fmt/format.h>

namespace polhode::report {

std::string origin_of(const scheme& s) {
  if (s.from.empty()) return "";
  auto out = fmt::format("{}: through {}, takes {}", s.name, s.from, s.takes);
  const char* before = "; measured, as not claimed: ";
  for (const auto& [name, order] : s.measured) {
    out += fmt::format("{}{} = {}", before, name, order == -1 ? "kept" : fmt::format("{}", order));
    before = ", ";
  }
  return out;
}

}  // namespace polhode::report
