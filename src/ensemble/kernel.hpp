// SPDX-License-Identifier: Apache-2.0
// Many paths of one scheme on one system, advanced together. The only virtual calls of the laboratory's loops are here:
// one per block of paths and chunk of steps.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace polhode {

/// Paths that advance together: one block, eight of the widest packs, so that the processor always has independent work
/// while a step waits for its own results. A multiple of every pack width in use.
inline constexpr int block_lanes = 64;

/// Increments of a block over a chunk of steps, [step][channel][lane] and [step][pair i<j][lane]; or of one path,
/// [step][channel] and [step][pair]. Neither dw nor singles: no noise.
struct increment_view {
  int steps = 0;
  std::span<const double> dw;
  std::span<const double> area;      ///< empty where nobody asks for areas
  std::span<const float> singles{};  ///< of a block, in place of dw: dw = scale * single
  double scale = 1;

  bool silent() const { return dw.empty() && singles.empty(); }

  /// `count` of the steps, from `first` on.
  increment_view part(int first, int count) const {
    const auto cut = [&]<class Real>(std::span<const Real> all) {
      const auto each = all.size() / static_cast<std::size_t>(steps);
      return all.subspan(static_cast<std::size_t>(first) * each, static_cast<std::size_t>(count) * each);
    };
    return {count, cut(dw), cut(area), cut(singles), scale};
  }
};

/// No noise at all: nothing is stored, and nothing drawn.
inline increment_view silence(int steps) { return {steps, {}, {}}; }

/// What one common noise does at each step, in a form that belongs to the kernel which made it.
struct shared_steps {
  std::size_t words = 0;  ///< per step
  std::vector<double> table;
};

/// Which piece of a run a call advances. Between pieces the states are the kernel's own: a splitting whose last flow
/// merges with the first of the next step leaves it out until the run ends.
struct piece {
  bool first = true, last = true;
};

class kernel {
 public:
  virtual ~kernel() = default;

  /// The time step for which it was made: increments are those of such steps, and nobody else says how long they are.
  virtual double dt() const = 0;

  /// Advances the states, [component][lane], through all steps of the view: every lane has its own noise, or there is
  /// none.
  virtual void advance(std::span<double> states, const increment_view&, piece = {}) const = 0;

  /// The steps of one path that is to drive all others. Without steps, the table is empty and `words` is what it will
  /// be.
  virtual shared_steps share(const increment_view& one_path) const = 0;
  virtual void advance(std::span<double> states, const shared_steps&, std::int64_t first_step, std::int64_t steps,
                       piece = {}) const = 0;

  /// Of states between two pieces: the states as they would be if the run ended here.
  virtual void finish(std::span<double> states) const = 0;
};

}  // namespace polhode
