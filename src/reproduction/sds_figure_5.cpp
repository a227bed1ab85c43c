// SPDX-License-Identifier: Apache-2.0
// Figure 5 of Gogoi, Panda, Hazra and Pakrashi: orders 1, 2 and 3 on
//
//   dz = [1 + (z x A z)] x z dt + 0.002 (1 x z) o dW,   1 = (1, 1, 1),   A = 1 1^T - identity
//
// With s = 1.z it is s' = s (3 - s^2), and a turn about (1, 1, 1) that drift and noise share.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <polhode/integrate.hpp>
#include <polhode/lie/so3.hpp>
#include <polhode/schemes/lie_euler.hpp>
#include <polhode/schemes/lie_heun.hpp>
#include <polhode/systems/constant_noise.hpp>

#include "reproduction/judged.hpp"
#include "reproduction/scenes.hpp"
#include "reproduction/sds_on_s2.hpp"

namespace polhode {
namespace {

constexpr double strength = 0.002, root3 = 1.7320508075688772;
constexpr point_on_s2 start{{0, 1, 0}};
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

/// The solution at time 1 of a path that ends at W.
point_on_s2 exact_end(double wiener) {
  const double along = 1 / std::sqrt(3 * (1 + 2 * std::exp(-6.0))), angle = root3 * (1 + strength * wiener);
  const point_on_s2 across{{-1.0 / 3, 2.0 / 3, -1.0 / 3}}, one{{1, 1, 1}};
  const auto turned = std::cos(angle) * across + (std::sin(angle) / root3) * cross(one, across);
  return along * one + radius_at_end() / std::sqrt(2.0 / 3) * turned;
}

double length_of(const point_on_s2& z) { return std::sqrt(dot(z, z)); }

/// End of a path less that of the exact solution under the same noise.
template <class Scheme>
point_on_s2 error_of_path(const relaxation_to_axis& system, int level, noise_address address) {
  const double dt = std::exp2(-level);
  const std::uint64_t steps = 1U << level;
  double wiener = 0;
  for (auto a = address; a.step < steps; ++a.step) wiener += wiener_at<3>(a, dt, system.active_channels()).dw[0];
  return integrate<Scheme>(system, start, dt, steps, address) - exact_end(wiener);
}

/// |E[z_dt] - E[z]| at time 1 over dt, of a group of paths.
template <class Scheme>
std::vector<double> errors_of(std::uint64_t first, int paths, std::uint64_t seed) {
  const relaxation_to_axis system;
  std::vector<double> out;
  for (int level = coarsest; level <= finest; ++level) {
    point_on_s2 mean{};
    for (int p = 0; p < paths; ++p) {
      noise_address address{.seed = seed};
      address.path = first + static_cast<std::uint64_t>(p);
      mean = mean + (1.0 / paths) * error_of_path<Scheme>(system, level, address);
    }
    out.push_back(length_of(mean));
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
  const int paths = by_effort(o.effort, 16, 64, 256);
  const auto dt = step_sizes();
  std::vector<double> slopes;
  for (int g = 0; g < groups; ++g)
    slopes.push_back(slope_of_means(errors_of<Scheme>(static_cast<std::uint64_t>(g * paths), paths, o.seed), dt));
  out.numbers.push_back(
      compared(fmt::format("figure 5, {} (here {}): order of the mean, dt = 2^-3 to 2^-9", theirs, Scheme::info.name),
               published, 0.1, mean_interval(slopes),
               "tolerance: 0.1, as for every order here; against the exact solution, which has a closed form"));
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

}  // namespace

void add_figure_5(const reproduce_options& o, report::reproduction& out) {
  compare_order<lie_euler>(1, "g-Weak 1.0", o, out);
  compare_order<lie_heun>(2, "g-Weak 2.0", o, out);
  const double floor = radius_at_end() * strength * root3 * std::sqrt(4 / std::numbers::pi);
  out.notes.push_back(
      fmt::format("Figure 5 draws single paths, each dt with a noise of its own, against a path with yet another: two "
                  "such paths lie {:.2g} apart in the mean however small dt is, so that what it shows below is chance. "
                  "In all but this noise it is a deterministic equation, and its orders are those of that one.",
                  floor));
}

}  // namespace polhode
