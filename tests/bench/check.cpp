// SPDX-License-Identifier: Apache-2.0
#include "bench/check.hpp"

#include <fmt/core.h>

#include <cmath>

#include "bench/catalogue.hpp"
#include "bench/ensemble_loop.hpp"
#include "bench/yardsticks.hpp"
#include "scene/scene.hpp"

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

/// Independent noise: one step dt of scattering has E|dPi|^2 = 2 sigma^2 |Pi|^2 dt to leading order, here dt/2. The
/// mean of n squares, nearly exponential in law, is off by less than five of its deviations 1/sqrt(n).
bool scatters(std::string_view what, const momentum& start, std::span<const momentum> ends) {
  double sum = 0;
  for (const auto& p : ends) sum += std::pow(std::hypot(p[0] - start[0], p[1] - start[1], p[2] - start[2]), 2);
  const double n = static_cast<double>(ends.size()), ratio = sum / n / (dt / 2);
  const bool good = std::fabs(ratio - 1) < 5 / std::sqrt(n) + dt;
  fmt::print("{} {}, independent noise: {:.3f} of the variance\n", good ? "ok  " : "FAIL", what, ratio);
  return good;
}

bool noise_agrees(const momentum& start) {
  constexpr int samples = 16 * soa_paths;
  const auto noise = ensemble_noise::independent;
  bool good = true;
  for (std::size_t i = 0; i < main_schemes.size(); ++i) {
    std::vector<momentum> ends;
    for (int n = 0; n < samples; ++n) ends.push_back(eigen_std(static_cast<yard_scheme>(i), noise, start, {}, 1, dt));
    good &= scatters(fmt::format("eigen_std {}", main_schemes[i]), start, ends);
  }
  std::vector<momentum> ends;
  while (ends.size() < samples) {
    const auto states = soa_ziggurat_heun(noise, start, {}, 1, dt);
    for (std::size_t k = 0; k < soa_paths; ++k)
      ends.push_back({states[k], states[soa_paths + k], states[2 * soa_paths + k]});
  }
  return scatters("soa_ziggurat", start, ends) && good;
}

}  // namespace

bool yardsticks_agree() {
  const auto paper = load_scene("paper");
  const momentum start{paper.momentum[0], paper.momentum[1], paper.momentum[2]};
  const isa widest = usable_isas().back();
  const shared_increments increments(*bind_scene(paper).model, seed, steps, dt, false, 1);
  const auto w = increments.view(0, steps).dw;
  const auto ours = [&](std::string_view scheme, ensemble_noise noise) {
    return first_of(ensemble_block(widest, paper, scheme, noise).advance());
  };
  // The same algorithm differs by rounding; others by their own error, of order dt^2 here.
  const double rounding = 1e-12, own_error = 1e-5;
  bool good = true;
  for (const auto noise : {ensemble_noise::none, ensemble_noise::common}) {
    const auto what = [&](const char* yardstick) { return fmt::format("{}, {} noise", yardstick, name_of(noise)); };
    const auto eigen = [&](yard_scheme s) { return eigen_std(s, noise, start, w, steps, dt); };
    good &= near(what("eigen_std heun"), eigen(yard_scheme::heun), ours("heun", noise), rounding);
    good &= near(what("eigen_std lie_heun"), eigen(yard_scheme::lie_heun), ours("lie_heun", noise), rounding);
    good &= near(what("eigen_std strang"), eigen(yard_scheme::strang), ours("strang", noise), own_error);
    good &= near(what("soa_ziggurat"), first_of(soa_ziggurat_heun(noise, start, w, steps, dt)), ours("heun", noise),
                 rounding);
  }
  const auto dw = block_of_increments(paper);
  for (std::size_t i = 0; i < main_schemes.size(); ++i) {
    const auto scheme = static_cast<yard_scheme>(i);
    good &=
        near(fmt::format("installed headers, {}", main_schemes[i]), first_of(by_headers(scheme, start, dw, steps, dt)),
             first_of(by_scalar_kernel(scheme, start, dw, steps, dt)), rounding);
  }
  const auto none = ours("heun", ensemble_noise::none);
  for (const isa level : usable_isas())
    good &= near(by_hand_key(level), first_of(heun_by_hand(level, paper, steps, dt)), none, rounding);
  good &= near("odeint_rk4, 16 times the steps", odeint_rk4(start, steps, dt), odeint_rk4(start, 16 * steps, dt / 16),
               1e-8);
  good &= near("odeint_rk4 and heun", odeint_rk4(start, steps, dt), none, own_error);
  return noise_agrees(start) && good;
}

}  // namespace polhode::bench
