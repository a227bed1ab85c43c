// SPDX-License-Identifier: Apache-2.0
#include "reports/model/finite.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace polhode::report {
namespace {

bool any_not_finite(std::initializer_list<std::optional<double>> numbers) {
  for (const auto& number : numbers)
    if (number && !std::isfinite(*number)) return true;
  return false;
}

}  // namespace

std::optional<double> finite(std::optional<double> number) {
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<double> half_width(const measurement& row) {
  if (!row.low && !row.high) return std::nullopt;
  if (row.low && row.high) return (*row.high - *row.low) / 2;
  if (!row.value) return 0;
  return std::max(0.0, row.high ? *row.high - *row.value : *row.value - *row.low);
}

bool is_sampled(const measurement& row) { return row.method == "sampled"; }

std::string status_of(const measurement& row) {
  if (row.status != "ok") return row.status;
  const auto lost = [](const coordinate& c) { return !std::isfinite(c.value); };
  if (any_not_finite({row.value, row.low, row.high}) || std::ranges::any_of(row.at, lost)) return "not finite";
  return row.value ? "ok" : "missing";
}

std::string reason_of(const verdict& row) {
  if (!any_not_finite({row.expected, row.estimate, row.low, row.high})) return row.reason;
  return row.reason.empty() ? "not finite" : row.reason + "; not finite";
}

}  // namespace polhode::report
