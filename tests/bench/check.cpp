#include "bench/check.hpp"

#include <fmt/core.h>

#include <cmath>

#include "bench/catalogue.hpp"
#include "bench/ensemble_loop.hpp"
#include "bench/yardsticks.hpp"
#include "registry/scene.hpp"

namespace polhode::bench {
namespace {

momentum first_of(std::span<const double> states) {
  const auto paths = states.size() / 3;
  return {states[0], states[paths], states[2 * paths]};
}

/// Within a tolerance; NaN is not.
bool near(std::string_view what, const momentum& a, const momentum& b, double tolerance) {
  const double apart = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  const bool good = apart <= tolerance;
  fmt::print("{} {}: {:.1e} apart, {:.1e} allowed\n", good ? "ok  " : "FAIL", what, apart, tolerance);
  return good;
}

}  // namespace

bool yardsticks_agree() {
  const auto paper = load_scene("paper");
  const momentum start{paper.momentum[0], paper.momentum[1], paper.momentum[2]};
  const isa widest = usable_isas().back();
  const shared_increments increments(*bind_rigid_body(paper).model, seed, steps, dt, false, 1);
  const auto w = increments.view(0, steps).dw;
  const auto ours = [&](std::string_view scheme, ensemble_noise noise) {
    return first_of(ensemble_block(widest, paper, scheme, noise).advance());
  };
  // The same algorithm differs by rounding; Strang starts its palindrome elsewhere and differs by its own error.
  const double rounding = 1e-12, strang_none = 1e-4, strang_common = 1e-2;
  bool good = true;
  for (const auto noise : {ensemble_noise::none, ensemble_noise::common}) {
    const auto what = [&](const char* yardstick) { return fmt::format("{}, {} noise", yardstick, name_of(noise)); };
    const auto eigen = [&](yard_scheme s) { return eigen_std(s, noise, start, w, steps, dt); };
    good &= near(what("eigen_std heun"), eigen(yard_scheme::heun), ours("heun", noise), rounding);
    good &= near(what("eigen_std lie_heun"), eigen(yard_scheme::lie_heun), ours("lie_heun", noise), rounding);
    good &= near(what("eigen_std strang"), eigen(yard_scheme::strang), ours("strang", noise),
                 noise == ensemble_noise::none ? strang_none : strang_common);
    good &= near(what("soa_ziggurat"), first_of(soa_ziggurat_heun(noise, start, w, steps, dt)), ours("heun", noise),
                 rounding);
  }
  const auto none = ours("heun", ensemble_noise::none);
  for (const isa level : usable_isas())
    good &= near(by_hand_key(level), first_of(heun_by_hand(level, paper, steps, dt)), none, rounding);
  good &= near("odeint_rk4, 16 times the steps", odeint_rk4(start, steps, dt), odeint_rk4(start, 16 * steps, dt / 16),
               1e-8);
  good &= near("odeint_rk4 and heun", odeint_rk4(start, steps, dt), none, strang_none);
  return good;
}

}  // namespace polhode::bench
