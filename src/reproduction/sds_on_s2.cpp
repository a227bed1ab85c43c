// SPDX-License-Identifier: Apache-2.0
// Weak Ito-Taylor schemes on the sphere, tried by their authors on two equations: sds_figure_5.cpp, and
//
//   figures 3, 4: a body of random inertia, dz = drift dt + (Omega x z) dW in Ito's sense, Omega = I^-1 z
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <polhode/integrate.hpp>
#include <polhode/lie/so3.hpp>

#include "reproduction/cases.hpp"
#include "reproduction/judged.hpp"
#include "reproduction/sds_on_s2.hpp"
#include "statistics/resample.hpp"

namespace polhode {
namespace {

constexpr std::array<double, 3> inertia{2, 0.4, 0.6};
constexpr double step = 0.01;
constexpr int steps_to_end = 200;

point_on_s2 body_start() { return {{std::sin(1.1), 0, std::cos(1.1)}}; }

/// One step of both in Ito's sense; the rotation by v = drift dt + Omega dW, and the plain Euler step.
point_on_s2 rotated(const point_on_s2& z, double dw) {
  const point_on_s2 w{{z[0] / inertia[0], z[1] / inertia[1], z[2] / inertia[2]}};
  const point_on_s2 drift{{0.5 * w[1] * w[2], -0.5 * w[0] * w[2], 0.5 * w[0] * w[1]}};
  return so3::exp_action(-1.0 * (step * drift + dw * w), z);
}
point_on_s2 translated(const point_on_s2& z, double dw) {
  const point_on_s2 w{{z[0] / inertia[0], z[1] / inertia[1], z[2] / inertia[2]}};
  const point_on_s2 drift{{-0.5 * (w[1] * w[1] + w[2] * w[2]) * z[0],
                           w[0] * w[1] * z[0] - 0.5 * (w[0] * w[0] + w[2] * w[2]) * z[1],
                           w[0] * w[2] * z[0] + w[1] * w[2] * z[1] - 0.5 * (w[0] * w[0] + w[1] * w[1]) * z[2]}};
  return z + step * drift + dw * cross(w, z);
}

struct body_path {
  double off_sphere = 0;  ///< the largest ||z|^2 - 1|
  point_on_s2 end;
};
template <class Step>
body_path body_run(Step one, std::uint64_t path, std::uint64_t seed) {
  body_path out{0, body_start()};
  noise_address address{.seed = seed};
  address.path = path;
  for (int i = 0; i < steps_to_end; ++i, ++address.step) {
    out.end = one(out.end, wiener_at<1>(address, step).dw[0]);
    out.off_sphere = std::max(out.off_sphere, std::fabs(dot(out.end, out.end) - 1));
  }
  return out;
}

// Heights of the boxes that Figure_4.m draws around the curves of both kinds of schemes.
constexpr double most_geometric = 1.6e-14, least_plain = 5e-5, most_plain = 8;

void compare_body(const reproduce_options& o, report::reproduction& out) {
  const int paths = by_effort(o.effort, 500, 10'000, 10'000);
  double geometric = 0;
  std::vector<double> plain;
  point_on_s2 mean{};
  for (int p = 0; p < paths; ++p) {
    const auto kept = body_run(rotated, static_cast<std::uint64_t>(p), o.seed);
    geometric = std::max(geometric, kept.off_sphere);
    mean = mean + (1.0 / paths) * kept.end;
    plain.push_back(body_run(translated, static_cast<std::uint64_t>(p), o.seed).off_sphere);
  }
  const auto [low, high] = central_interval(plain, 0.95);
  const auto boxed = fmt::format("of {} paths; the bound is the box that Figure_4.m draws around the curves", paths);
  out.numbers.push_back(compared_at_most("figure 4, g-Weak 1.0: largest ||z|^2 - 1| up to T = 2", most_geometric,
                                         within(geometric, 0), boxed));
  out.numbers.push_back(compared_between("figure 4, Weak 1.0 (Euler): largest ||z|^2 - 1| up to T = 2", least_plain,
                                         most_plain, {mean_interval(plain).value, low, high},
                                         "mean and central 95 % " + boxed));
  out.numbers.push_back(explained_by(
      compared("figures 3, 4: scatter of the samples at T = 2, sqrt(1 - |mean|^2)", 0, 1e-12,
               within(std::sqrt(1 - dot(mean, mean)), 0), ""),
      fmt::format(
          "their 10,000 samples are one path: rng(0) stands inside the loop over samples, so that what is drawn "
          "as a mean is a single path; ours are {} independent ones",
          paths)));
}

}  // namespace

report::reproduction sds_on_s2(const reproduce_options& o) {
  report::reproduction out;
  out.source =
      "Gogoi, Panda, Hazra, Pakrashi, Weak Ito-Taylor Schemes for Geometric Stochastic Differential Equations on S^2 "
      "Manifold, Proc. R. Soc. A, by its programs (stochastic-dynamics/SDEs-on-S2, commit d0f0901): Figure_3.m, "
      "Figure_4.m, Figure_5.m";
  out.notes = {
      "No scene: the noise of figures 3 and 4 depends on the state, and the drift of figure 5 belongs to two energies.",
      "Published are orders (1, 2, 3) and plots without a table; the paper itself was not at hand, its programs were.",
      "g-Weak 1.0 is lie_euler; for g-Weak 2.0 stands lie_heun, another scheme of that order under one small noise "
      "vector; g-Weak 3.0 has no counterpart here."};
  add_figure_5(o, out);
  compare_body(o, out);
  return out;
}

}  // namespace polhode
