#include "experiments/price_list.hpp"

#include <algorithm>

#include "experiments/extrapolation.hpp"

namespace polhode {
namespace {

/// Whose steps a scheme's are, and in how many runs.
struct origin {
  std::string scheme;
  int runs = 1;
};

origin origin_of(const std::string& scheme) {
  for (const auto& e : extrapolations)
    if (e.name == scheme) return {std::string(extrapolated_from), e.levels()};
  return {scheme};
}

}  // namespace

price_list::price_list(const context& c) : context_(c), still_(c.subject.without_noise()) {}

std::optional<price> price_list::of_path(const std::string& scheme, double dt, bool silent) {
  const auto from = origin_of(scheme);
  price sum;
  for (int run = 0; run < from.runs; ++run, dt /= 2) {
    const auto step = of_step(from.scheme, dt, silent);
    if (!step) return std::nullopt;
    sum.steps += 1 / dt;
    sum.normals += step->normals / dt;
    sum.ns += step->ns / dt;
    sum.low += step->low / dt;
    sum.high += step->high / dt;
  }
  return sum;
}

std::optional<step_cost> price_list::of_step(const std::string& scheme, double dt, bool silent) {
  const auto& s = silent ? still_ : context_.subject;
  const auto entry = std::ranges::find(s.schemes, scheme, [](const scheme_entry& e) { return e.info.name; });
  if (entry == s.schemes.end()) return std::nullopt;
  const auto [at, is_new] = known_.try_emplace({scheme, dt, silent});
  if (is_new) {
    const context c{s, context_.effort, 1, context_.seed, context_.generator};
    at->second = cost_of_step(c, *entry, dt);
  }
  return at->second;
}

}  // namespace polhode
