#include "experiments/combined_law_error.hpp"

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

constexpr double finest = 1e-6, coarsest = 0.02, rough = 0.1;  // tolerances, of an error

}  // namespace

law_error combined_error(const extrapolation& combination, double dt, double accuracy, const law_error_at& error_at) {
  auto found = error_at(dt, rough, 1);
  const double share = accuracy / found.error.cwiseAbs().maxCoeff();
  const double needed = std::isfinite(share) ? std::clamp(share, finest, coarsest) : coarsest;
  error_table table{std::string(combination.name), {}, {}, {}};
  for (int i = 0; i < combination.levels(); ++i) {
    const auto level = error_at(dt / (1 << i), needed, 1 << i);
    table.add(dt / (1 << i), {level.error, level.uncertainty, true});
  }
  table = extrapolate(table, combination);
  found.error = table.error[0];
  found.uncertainty = table.uncertainty[0];
  return found;
}

}  // namespace polhode
