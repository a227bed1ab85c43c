// SPDX-License-Identifier: Apache-2.0
#include "experiments/work_precision/combined_law_error.hpp"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr double coarsest = 0.02, finest = 1e-6;        // tolerances of what is combined, of an error
constexpr double most_finer = 0.01, least_finer = 0.3;  // from one try to the next
constexpr double hardly_combined = 0.85;                // falls to that share where the finest operators are in it

law_error combined_at(const extrapolation& combination, double dt, double tolerance, const law_error_at& error_at) {
  error_table table{std::string(combination.name), {}, {}, {}};
  law_error out;
  for (int i = 0; i < combination.levels(); ++i) {
    auto level = error_at(dt / (1 << i), tolerance, 1 << i);
    table.add(dt / (1 << i), {level.error, level.uncertainty, true});
    if (i == 0) out.times = std::move(level.times);
  }
  table = extrapolate(table, combination);
  out.error = table.error[0];
  out.uncertainty = table.uncertainty[0];
  return out;
}

}  // namespace

law_error combined_error(const extrapolation& combination, double dt, double relative, double accuracy,
                         const law_error_at& error_at) {
  double before = HUGE_VAL;  // the uncertainty of the last try that was another one
  for (double tolerance = coarsest;;) {
    auto found = combined_at(combination, dt, tolerance, error_at);
    const double wanted = std::max(accuracy, relative * found.error.cwiseAbs().maxCoeff());
    const double known = found.uncertainty.maxCoeff();
    const bool at_its_end = known < before && known > hardly_combined * before;
    if (!(known > wanted) || tolerance <= finest || at_its_end) return found;
    before = known;
    tolerance = std::max(finest, tolerance * std::clamp(wanted / known, most_finer, least_finer));
  }
}

}  // namespace polhode
