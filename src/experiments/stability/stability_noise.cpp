// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability/stability_noise.hpp"

namespace polhode {
namespace {

/// Of those that keep the sphere, as the long drift is theirs alone; of all where none does.
std::string_view heard_of(const subject& s) {
  std::vector<scheme_entry> on_the_sphere;
  for (const auto& scheme : s.schemes)
    if (scheme.info.casimir.exact) on_the_sphere.push_back(scheme);
  return heard_among(on_the_sphere.empty() ? s.schemes : on_the_sphere).info.name;
}

}  // namespace

heard_noise::heard_noise(const subject& s) : log_(*s.model, 0, {}), scheme_(heard_of(s)) {
  for (const char* name : {"reference", "border", "map", "rare breaks", "long drift"}) log_.open({name}, 0);
}

block_listener heard_noise::listener(part p) {
  return [this, p](std::int64_t first, const increment_view& v, double dt) { log_.add_in_turn(first, v, dt, p); };
}

block_listener heard_noise::listener(part p, const scheme_entry& scheme) {
  return scheme.info.name == scheme_ ? listener(p) : block_listener{};
}

}  // namespace polhode
