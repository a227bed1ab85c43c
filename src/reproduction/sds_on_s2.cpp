// Weak Ito-Taylor schemes of order 1 to 3 on the sphere, tried by their authors on two equations:
//
//   figures 3, 4: a body of random inertia, dz = drift dt + (Omega x z) dW in Ito's sense, Omega = I^-1 z
//   figure 5:     dz = [1 + (z x A z)] x z dt + 0.002 (1 x z) o dW,  1 = (1, 1, 1), A = 1 1^T - identity
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <polhode/integrate.hpp>
#include <polhode/lie/so3.hpp>
#include <polhode/schemes/lie_euler.hpp>
#include <polhode/schemes/lie_heun.hpp>
#include <polhode/systems/constant_noise.hpp>

#include "reproduction/cases.hpp"
#include "reproduction/judged.hpp"
#include "reproduction/scenes.hpp"

namespace polhode {
namespace {

using state = vec<double, 3>;

// Figure 5. With s = 1.z it is s' = s (3 - s^2), and a turn about (1, 1, 1) that drift and noise share.
constexpr double strength = 0.002, root3 = 1.7320508075688772;
constexpr state start{{0, 1, 0}};
constexpr int coarsest = 3, finest = 9;  // dt = 2^-3 to 2^-9, T = 1

struct relaxation_to_axis : constant_noise<so3> {
  using algebra = so3;
  relaxation_to_axis() : constant_noise(along()) {}

  /// dz = z x a(z) dt: a = -1 + A z x z, and A z x z = s (1 x z).
  template <class S>
  vec<S, 3> generator(const vec<S, 3>& z) const {
    const vec<S, 3> one{{S(1.0), S(1.0), S(1.0)}};
    return S(-1.0) * one + dot(one, z) * cross(one, z);
  }
  template <class S>
  S energy(const vec<S, 3>& z) const {
    const S s = z[0] + z[1] + z[2];
    return S(-0.5) * s * s;
  }

 private:
  static constant_noise along() {
    const std::array<column, 1> one{{{{-strength, -strength, -strength}}}};
    return from_vectors(one);
  }
};

/// How far the solution lies from the axis (1, 1, 1) at time 1: s^2 = 3 / (1 + 2 exp(-6 t)).
double radius_at_end() { return std::sqrt(1 - 1 / (1 + 2 * std::exp(-6.0))); }

/// E[z_1]: the angle about the axis is sqrt 3 + N(0, 3 strength^2).
state exact_mean() {
  const double along = 1 / std::sqrt(3 * (1 + 2 * std::exp(-6.0)));
  const double shrunk = radius_at_end() * std::exp(-1.5 * strength * strength) / std::sqrt(2.0 / 3);
  const state across{{-1.0 / 3, 2.0 / 3, -1.0 / 3}}, one{{1, 1, 1}};
  const auto turned = std::cos(root3) * across + (std::sin(root3) / root3) * cross(one, across);
  return along * one + shrunk * turned;
}

double length_of(const state& z) { return std::sqrt(dot(z, z)); }

/// |E[z_1] - mean of a group of paths| over dt.
template <class Scheme>
std::vector<double> errors_of(std::uint64_t first, int paths, std::uint64_t seed) {
  const relaxation_to_axis system;
  std::vector<double> out;
  for (int level = coarsest; level <= finest; ++level) {
    state mean{};
    for (int p = 0; p < paths; ++p) {
      noise_address address{.seed = seed};
      address.path = first + static_cast<std::uint64_t>(p);
      mean = mean + (1.0 / paths) * integrate<Scheme>(system, start, std::exp2(-level), 1U << level, address);
    }
    out.push_back(length_of(mean - exact_mean()));
  }
  return out;
}

std::vector<double> step_sizes() {
  std::vector<double> out;
  for (int level = coarsest; level <= finest; ++level) out.push_back(std::exp2(-level));
  return out;
}

template <class Scheme>
void compare_order(double published, const char* theirs, const reproduce_options& o, report::reproduction& out) {
  constexpr int groups = 8;
  const int paths = by_effort(o.effort, 16, 256, 1024);
  const auto dt = step_sizes();
  std::vector<double> slopes;
  for (int g = 0; g < groups; ++g)
    slopes.push_back(slope_of_means(errors_of<Scheme>(static_cast<std::uint64_t>(g * paths), paths, o.seed), dt));
  out.numbers.push_back(
      compared(fmt::format("figure 5, {} (here {}): order of the mean, dt = 2^-3 to 2^-9", theirs, Scheme::info.name),
               published, 0.1, mean_interval(slopes),
               "tolerance: 0.1, as for every order here; against the exact mean, which has a closed form"));
  report::reproduced_curve curve{fmt::format("Error of the mean at T = 1: {}", Scheme::info.name),
                                 "dt",
                                 "|E[z_T] - E[z]|",
                                 fmt::format("a line of order {:g}", published),
                                 std::string(Scheme::info.name),
                                 true,
                                 {}};
  const auto e = errors_of<Scheme>(0, groups * paths, o.seed);
  for (std::size_t l = 0; l < dt.size(); ++l)
    curve.points.push_back({dt[l], e.back() * std::pow(dt[l] / dt.back(), published), e[l]});
  out.curves.push_back(std::move(curve));
}

// Figures 3 and 4.
constexpr std::array<double, 3> inertia{2, 0.4, 0.6};
constexpr double step = 0.01;
constexpr int steps_to_end = 200;

state body_start() { return {{std::sin(1.1), 0, std::cos(1.1)}}; }

/// One step of both in Ito's sense; the rotation by v = drift dt + Omega dW, and the plain Euler step.
state rotated(const state& z, double dw) {
  const state w{{z[0] / inertia[0], z[1] / inertia[1], z[2] / inertia[2]}};
  const state drift{{0.5 * w[1] * w[2], -0.5 * w[0] * w[2], 0.5 * w[0] * w[1]}};
  return so3::exp_action(-1.0 * (step * drift + dw * w), z);
}
state translated(const state& z, double dw) {
  const state w{{z[0] / inertia[0], z[1] / inertia[1], z[2] / inertia[2]}};
  const state drift{{-0.5 * (w[1] * w[1] + w[2] * w[2]) * z[0],
                     w[0] * w[1] * z[0] - 0.5 * (w[0] * w[0] + w[2] * w[2]) * z[1],
                     w[0] * w[2] * z[0] + w[1] * w[2] * z[1] - 0.5 * (w[0] * w[0] + w[1] * w[1]) * z[2]}};
  return z + step * drift + dw * cross(w, z);
}

struct body_path {
  double off_sphere = 0;  ///< the largest ||z|^2 - 1|
  state end;
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

void compare_body(const reproduce_options& o, report::reproduction& out) {
  const int paths = by_effort(o.effort, 500, 10'000, 10'000);
  double geometric = 0;
  std::vector<double> plain, squares;
  for (int p = 0; p < paths; ++p) {
    const auto kept = body_run(rotated, static_cast<std::uint64_t>(p), o.seed);
    geometric = std::max(geometric, kept.off_sphere);
    plain.push_back(body_run(translated, static_cast<std::uint64_t>(p), o.seed).off_sphere);
    const auto ahead = kept.end - body_start();
    squares.push_back(dot(ahead, ahead));
  }
  out.numbers.push_back(compared_at_most("figure 4, g-Weak 1.0: largest ||z|^2 - 1| up to T = 2", 1e-13,
                                         within(geometric, 0), fmt::format("of {} paths; theirs is rounding", paths)));
  out.numbers.push_back(compared_at_least("figure 4, Weak 1.0 (Euler): largest ||z|^2 - 1| up to T = 2, mean", 1e-3,
                                          mean_interval(plain), "theirs leaves the sphere; read off no table"));
  state mean{};
  double spread = 0;
  for (int p = 0; p < paths; ++p)
    mean = mean + (1.0 / paths) * body_run(rotated, static_cast<std::uint64_t>(p), o.seed).end;
  spread = std::sqrt(1 - dot(mean, mean));
  out.numbers.push_back(explained_by(
      compared("figures 3, 4: scatter of the samples at T = 2, sqrt(1 - |mean|^2)", 0, 1e-12, within(spread, 0), ""),
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
      "Manifold, Proc. R. Soc. A, by its programs (stochastic-dynamics/SDEs-on-S2): Figure_3.m, Figure_4.m, Figure_5.m";
  const double floor = radius_at_end() * strength * root3 * std::sqrt(4 / std::numbers::pi);
  out.notes = {
      "No scene: the noise of figures 3 and 4 depends on the state, and the drift of figure 5 belongs to two energies.",
      "Published are orders (1, 2, 3) and plots without a table; the paper itself was not at hand, its programs were.",
      fmt::format("Figure 5 draws single paths, each dt with a noise of its own, against a path with yet another: two "
                  "such paths lie {:.2g} apart in the mean however small dt is, so that what it shows below is chance. "
                  "In all but this noise it is a deterministic equation, and its orders are those of that one.",
                  floor),
      "g-Weak 1.0 is lie_euler; for g-Weak 2.0 stands lie_heun, another scheme of that order under one small noise "
      "vector; g-Weak 3.0 has no counterpart here."};
  compare_order<lie_euler>(1, "g-Weak 1.0", o, out);
  compare_order<lie_heun>(2, "g-Weak 2.0", o, out);
  compare_body(o, out);
  return out;
}

}  // namespace polhode
