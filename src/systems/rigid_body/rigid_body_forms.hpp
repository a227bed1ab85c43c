// SPDX-License-Identifier: Apache-2.0
// The rigid body's kernels: which parts a scene and a step size need is decided once, here, outside every loop.
#pragma once

#include <algorithm>
#include <array>
#include <bit>

#include <polhode/systems/rigid_body.hpp>
#include "systems/rigid_body/motion/rigid_body_at.hpp"

#include "ensemble/kernel_of.hpp"

namespace polhode {

/// What the body fixes for every step. `first_axis`: the body's axis that is numbered 1 in the kernel (a symmetric body
/// is turned so that its odd axis is 3).
inline rigid_body_constants constants_of(const rigid_body& body, double dt, double radius, int first_axis,
                                         rotation_size size) {
  vec<double, 3> inverse;
  for (int k = 0; k < 3; ++k) inverse[k] = body.inverse_inertia[(k + first_axis) % 3];
  return {inverse, body.theta, dt, radius, size};
}

/// A rigid body bound to its step size, in the forms of kernel_of; `bound` by its constants.
template <body_parts parts, rotation_size size>
class rigid_body_forms {
 public:
  rigid_body_forms(const rigid_body& body, const rigid_body_at<parts, size, no_noise>& bound, int first_axis)
      : body_(body),
        first_axis_(first_axis),
        diagonal_(first_axis == 0 && body.sigma().isDiagonal(0.0)),
        own_(bound.with(noise_of(body))) {}

  auto own(double unit) const {
    diagonal_noise noise = own_;
    noise.scale = unit * noise.scale;
    return own_.with(noise);
  }
  auto silent() const { return own_.with(no_noise{}); }
  int axis(int k) const { return parts.last_turn ? k : (k + first_axis_) % 3; }

  /// Noise that is not diagonal in the kernel's axes is brought into their basis first.
  increment_view take(const increment_view& view, std::vector<double>& scratch) const {
    if (diagonal_) return view;
    const std::size_t rows = static_cast<std::size_t>(view.steps) * 3 * block_lanes,
                      areas = view.area.empty() ? 0 : rows;
    scratch.resize(rows + areas);
    for (int i = 0; i < view.steps; ++i)
      for (int lane = 0; lane < block_lanes; lane += static_cast<int>(pack::size())) {
        const auto at = static_cast<std::size_t>(i * 3 * block_lanes + lane);
        store_lanes(turned(body_.noise(load_increment<pack, 3>(view, static_cast<std::ptrdiff_t>(at)))),
                    scratch.data() + at);
        if (areas == 0) continue;
        const auto l = turned(body_.area_noise(load_lanes<pack, 3>(view.area.data() + at)));
        store_lanes(vec<pack, 3>{{l[2], -l[1], l[0]}}, scratch.data() + rows + at);  // as pairs of the unit vectors
      }
    const std::span<const double> all(scratch);
    return {view.steps, all.first(rows), all.subspan(rows, areas)};
  }

  shared_steps share(const increment_view& path) const {
    shared_steps out{words, std::vector<double>(static_cast<std::size_t>(path.steps) * words)};
    for (std::size_t i = 0; i < static_cast<std::size_t>(path.steps); ++i) {
      const auto row = [&](std::span<const double> all) {
        return all.empty() ? vec<double, 3>{} : vec<double, 3>{{all[3 * i], all[3 * i + 1], all[3 * i + 2]}};
      };
      const auto step = own_.share(turned(body_.noise(row(path.dw))), turned(body_.area_noise(row(path.area))));
      std::ranges::copy(std::bit_cast<std::array<double, words>>(step), out.table.data() + i * words);
    }
    return out;
  }
  auto common() const {
    shared_noise noise;
    noise.ito = own_.ito;
    return own_.with(noise);
  }
  template <class S, class System>
  wiener_levy<S, 3> enter(System& system, const double* row, double dt) const {
    std::array<double, words> raw;
    std::copy_n(row, words, raw.begin());
    system.step = std::bit_cast<shared_step>(raw);
    wiener_levy<S, 3> w;
    w.dt = dt;
    return w;
  }

 private:
  static constexpr std::size_t words = sizeof(shared_step) / sizeof(double);
  static_assert(std::is_trivially_copyable_v<shared_step>);

  template <class S>
  vec<S, 3> turned(const vec<S, 3>& v) const {
    return {{v[axis(0)], v[axis(1)], v[axis(2)]}};
  }

  diagonal_noise noise_of(const rigid_body& body) const {
    diagonal_noise out;
    if (diagonal_)
      for (int k = 0; k < 3; ++k) {
        out.scale[k] = body.sigma()(k, k);
        out.area_scale[k] =
            out.area_scale[k] * body.sigma()((k + 1) % 3, (k + 1) % 3) * body.sigma()((k + 2) % 3, (k + 2) % 3);
      }
    for (int j = 0; j < 3; ++j) {
      vec<double, 3> e{};
      e[axis(j)] = 1;
      const auto column = turned(body.ito_drift(e));
      for (int i = 0; i < 3; ++i) out.ito[static_cast<std::size_t>(i)][j] = column[i];
    }
    return out;
  }

  rigid_body body_;
  int first_axis_;
  bool diagonal_;
  rigid_body_at<parts, size, diagonal_noise> own_;
};

}  // namespace polhode
