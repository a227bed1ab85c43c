// SPDX-License-Identifier: Apache-2.0
#include "experiments/work_precision/cost_front.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace polhode {
namespace {

bool beats(const cost_point& a, const cost_point& b) {
  return a.resolved() && a.cost <= b.cost && a.error <= b.error && (a.cost < b.cost || a.error < b.error);
}

/// Between two values, a share of the way from the first in their logarithms.
double along_logarithms(double first, double second, double share) { return first * std::pow(second / first, share); }

}  // namespace

void mark_front(std::span<cost_point> points) {
  for (auto& p : points)
    p.front = p.resolved() && std::ranges::none_of(points, [&](const cost_point& other) { return beats(other, p); });
}

std::optional<reached> reach(std::vector<cost_point> of_scheme, double accuracy) {
  for (auto& p : of_scheme)
    if (!p.resolved()) p.error = p.error_high;
  std::ranges::sort(of_scheme, {}, &cost_point::dt);
  const auto above = std::ranges::find_if(of_scheme, [&](const cost_point& p) { return !(p.error <= accuracy); });
  if (above == of_scheme.begin()) return std::nullopt;
  const auto& fine = *std::prev(above);
  if (above == of_scheme.end()) return reached{fine.scheme, fine.dt, fine.cost, fine.cost_low, fine.cost_high, true};
  const auto& coarse = *above;
  double share = 0;
  if (fine.error > 0 && std::isfinite(coarse.error))
    share = std::log(accuracy / fine.error) / std::log(coarse.error / fine.error);
  return reached{fine.scheme, along_logarithms(fine.dt, coarse.dt, share),
                 along_logarithms(fine.cost, coarse.cost, share),
                 along_logarithms(fine.cost_low, coarse.cost_low, share),
                 along_logarithms(fine.cost_high, coarse.cost_high, share)};
}

std::vector<reached> ranking(std::span<const cost_point> points, double accuracy) {
  std::map<std::string, std::vector<cost_point>> by_scheme;
  for (const auto& p : points) by_scheme[p.scheme].push_back(p);
  std::vector<reached> out;
  for (auto& [_, own] : by_scheme)
    if (auto r = reach(std::move(own), accuracy)) out.push_back(*r);
  std::ranges::stable_sort(out, {}, &reached::cost);
  return out;
}

}  // namespace polhode
