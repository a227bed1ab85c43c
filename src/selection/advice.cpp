// SPDX-License-Identifier: Apache-2.0
#include "selection/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

/// Schemes that keep the Casimir exactly, at the winner's step.
std::string on_keeping_the_casimir(const std::vector<prospect>& all, const choice& winner) {
  const prospect *best = nullptr, *worst = nullptr;
  const auto error = [&](const prospect* p) { return p->law->at(winner.dt); };
  for (const auto& p : all) {
    if (!p.law || !p.who.scheme.info.casimir.exact || p.who.combination != nullptr) continue;
    if (!best || error(&p) < error(best)) best = &p;
    if (!worst || error(&p) > error(worst)) worst = &p;
  }
  if (!best || best == worst || error(worst) < 2 * error(best)) return "";
  return fmt::format(
      "keeping |Pi| is not accuracy: at dt = {:.3g} {} and {} both keep it, with errors of about {:.1e} and "
      "{:.1e}",
      winner.dt, best->who.name, worst->who.name, error(best), error(worst));
}

/// cost = k (factor / tolerance)^(1/order): where two such laws cross.
double crossing(const prospect& low, const prospect& high) {
  const double k = std::log(high.cost * high.dt) - std::log(low.cost * low.dt);
  const double a = 1 / low.law->order, b = 1 / high.law->order;
  return std::exp((a * std::log(low.law->factor) - b * std::log(high.law->factor) - k) / (a - b));
}

/// The cheapest scheme of a higher order than the winner's, and below which tolerance it pays.
std::string on_higher_order(const std::vector<prospect>& all, const choice& winner, double tolerance) {
  const auto first = std::ranges::find(all, winner.scheme, [](const prospect& p) { return p.who.name; });
  for (const auto& p : all) {  // by rising cost
    if (!p.law || !p.fault.empty() || p.law->order < first->law->order + 0.4 || p.who.name == winner.scheme) continue;
    const double t = crossing(*first, p);
    if (!(t < tolerance) || p.who.scheme.needs_areas) return "";
    return fmt::format("order {:.2g} ({}) is not cheaper here; it is below a tolerance of about {:.0e}", p.law->order,
                       p.who.name, t);
  }
  return "";
}

}  // namespace

std::vector<std::string> advice(const std::vector<prospect>& all, const choice& winner, double tolerance) {
  std::vector<std::string> out;
  for (auto text : {on_keeping_the_casimir(all, winner), on_higher_order(all, winner, tolerance)})
    if (!text.empty()) out.push_back(std::move(text));
  return out;
}

}  // namespace polhode
