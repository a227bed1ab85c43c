// SPDX-License-Identifier: Apache-2.0
// What can be wrong with increments: of one kernel (defective_kernel.hpp), or of the generator for the whole run.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "ensemble/noise/noise_defect.hpp"
#include "mutants/defect.hpp"

namespace polhode::test {

/// Numbers [step][row][lane], in units of `unit`.
template <class Real>
struct noise_rows {
  std::span<Real> values;
  std::size_t rows, lanes, steps;
  double unit;
  Real& at(std::size_t step, std::size_t row, std::size_t lane) { return values[(step * rows + row) * lanes + lane]; }

  template <class Change>
  void each(Change change) {
    for (std::size_t i = 0; i < steps; ++i)
      for (std::size_t lane = 0; lane < lanes; ++lane) change(i, lane);
  }
  void scale(double by) {
    for (Real& x : values) x = static_cast<Real>(x * by);
  }
  void mix_channels(double correlation) {
    const double rest = std::sqrt(1 - correlation * correlation);
    each([&](auto i, auto lane) {
      at(i, 1, lane) = static_cast<Real>(correlation * at(i, 0, lane) + rest * at(i, 1, lane));
    });
  }
  void clip(double most) {
    const auto bound = static_cast<Real>(most * unit);
    for (Real& x : values) x = std::clamp(x, -bound, bound);
  }
  void drop_beyond(double most) {
    each([&](auto i, auto lane) {
      const Real a = at(i, 0, lane), b = at(i, 1, lane), c = at(i, 2, lane);
      if (a * a + b * b + c * c <= most * most * unit * unit) return;
      for (std::size_t k = 0; k < rows; ++k) at(i, k, lane) = 0;
    });
  }
  /// Of a block alone: the nodes of a quadrature and a common path have one lane.
  void repeat_lanes(std::size_t last) {
    if (lanes == 1) return;
    each([&](auto i, auto lane) {
      if (lane < lanes - last) return;
      for (std::size_t k = 0; k < rows; ++k) at(i, k, lane) = at(i, k, lane - (lanes - last));
    });
  }
  /// Of a block alone, as above.
  void interchange_lanes(std::size_t by) {
    if (lanes == 1) return;
    for (std::size_t row = 0; row < steps * rows; ++row) {
      const auto all = values.subspan(row * lanes, lanes);
      std::rotate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(by), all.end());
    }
  }
  /// Of a block alone: the steps of a quadrature are nodes.
  void repeat_steps() {
    if (lanes == 1) return;
    for (std::size_t i = 1; i < steps; i += 2)
      std::copy_n(values.data() + (i - 1) * rows * lanes, rows * lanes, values.data() + i * rows * lanes);
  }
};

/// A defect of the increments of a kernel; others do nothing.
template <class Real>
void spoil_increments(const defect& d, noise_rows<Real> noise) {
  switch (d.kind) {
    case kind::dw: return noise.scale(1 + d.size);
    case kind::channels: return noise.mix_channels(d.size);
    case kind::clip: return noise.clip(d.size);
    case kind::branch: return noise.drop_beyond(d.size);
    case kind::lanes: return noise.repeat_lanes(static_cast<std::size_t>(d.size));
    case kind::neighbours: return noise.interchange_lanes(static_cast<std::size_t>(d.size));
    case kind::steps: return noise.repeat_steps();
    default: return;
  }
}

/// The generator's defect to be planted for a run, or nothing where the kind is none of those.
std::unique_ptr<noise_defect> defective_generator(const defect&);

}  // namespace polhode::test
