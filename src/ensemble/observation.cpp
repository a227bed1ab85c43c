#include "ensemble/observation.hpp"

#include <algorithm>
#include <cmath>

#include "ensemble/paths.hpp"
#include "ensemble/sphere_bins.hpp"

namespace polhode {
namespace {

/// Scaled first: a body that runs away has a direction as long as it is finite.
void see(std::span<const double> mu, std::vector<direction_bins>& seen) {
  const double largest = std::max({std::abs(mu[0]), std::abs(mu[1]), std::abs(mu[2])});
  if (largest == 0) return;
  const double x = mu[0] / largest, y = mu[1] / largest, z = mu[2] / largest;
  const double r = std::sqrt(x * x + y * y + z * z);
  seen.push_back({static_cast<std::uint32_t>(longitude_bins::of(x, y, z / r)),
                  static_cast<std::uint32_t>(hemisphere_bins::of(x / r, y / r, z / r))});
}

}  // namespace

void ensemble_moments::merge(const ensemble_moments& other) {
  energy.merge(other.energy);
  for (std::size_t k = 0; k < components.size(); ++k) components[k].merge(other.components[k]);
  lost += other.lost;
  casimir_change = std::max(casimir_change, other.casimir_change);
}

ensemble_observer::ensemble_observer(const model& m, std::span<const double> momentum)
    : model_(m), start_casimirs_(m.casimirs(momentum)) {
  for (const double c : start_casimirs_) casimir_scale_ = std::max(casimir_scale_, std::abs(c));
}

ensemble_moments ensemble_observer::nothing() const {
  return {{}, std::vector<running_moments>(static_cast<std::size_t>(model_.dimension())), 0, 0};
}

void ensemble_observer::observe(std::span<const double> states, int lanes, ensemble_moments& out,
                                std::vector<direction_bins>* seen) const {
  for (int lane = 0; lane < lanes; ++lane) {
    const auto mu = lane_of(states, lane, model_.dimension());
    if (!std::ranges::all_of(mu, [](double x) { return std::isfinite(x); })) {
      ++out.lost;
      continue;
    }
    out.energy.add(model_.energy(mu));
    for (std::size_t k = 0; k < mu.size(); ++k) out.components[k].add(mu[k]);
    const auto casimirs = model_.casimirs(mu);
    for (std::size_t k = 0; k < casimirs.size(); ++k)
      out.casimir_change = std::max(out.casimir_change, std::abs(casimirs[k] - start_casimirs_[k]) / casimir_scale_);
    if (seen != nullptr) see(mu, *seen);
  }
}

}  // namespace polhode
