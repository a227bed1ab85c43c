// SPDX-License-Identifier: Apache-2.0
#include "statistics/orders/level_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr double standard_errors = 3;

}  // namespace

std::vector<log_level> asymptotic_part(std::vector<log_level> kept) {
  while (kept.size() > least_levels) {
    const double off = std::fabs(off_the_others(kept));
    if (off <= off_the_line || off <= standard_errors * kept.front().error) break;
    kept.erase(kept.begin());
  }
  return kept;
}

level_choice choose_levels(std::vector<log_level> all, std::size_t left_out_at_floor) {
  std::ranges::sort(all, [](const auto& a, const auto& b) { return a.x > b.x; });
  const auto spare = all.size() - std::min<std::size_t>(all.size(), fitted_levels);
  const std::vector<log_level> finest(all.begin() + static_cast<std::ptrdiff_t>(spare), all.end());
  const auto kept = asymptotic_part(finest);
  const auto early = finest.size() - kept.size();
  return {finest, kept,
          fmt::format("{} levels used; left out: {} coarser than the finest {}, {} pre-asymptotic, {} at the "
                      "rounding floor or not finite",
                      kept.size(), spare, fitted_levels, early, left_out_at_floor)};
}

level_choice every_level(std::vector<log_level> all) { return {all, all, "every point that is finite and above zero"}; }

}  // namespace polhode
