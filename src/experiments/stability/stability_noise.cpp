// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability/stability_noise.hpp"

namespace polhode {
heard_noise::heard_noise(const subject& s) : log_(*s.model, 0, {}), scheme_(heard_among(s.schemes).info.name) {
  for (const char* name : {"reference", "border", "map", "rare breaks", "long drift"}) log_.open({name}, 0);
}

block_listener heard_noise::listener(part p) {
  return [this, p](std::int64_t first, const increment_view& v, double dt) { log_.add_in_turn(first, v, dt, p); };
}

block_listener heard_noise::listener(part p, const scheme_entry& scheme) {
  return scheme.info.name == scheme_ ? listener(p) : block_listener{};
}

}  // namespace polhode
