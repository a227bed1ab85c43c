// SPDX-License-Identifier: Apache-2.0
// The true solution on a block of paths, and how it answers to a little more noise, dissipation or time.
//
// Truth is the ordinary differential equation driven by the fine piecewise linear path
// (references/wong_zakai_equation.hpp). Its twin of a level is driven by the path that a scheme without Levy areas is
// given there, the increments of that level alone; twins converge to the truth with strong order 1/2 (1 where the noise
// commutes): Wong, Zakai, Ann. Math. Stat. 36 (1965) 1560-1564. A scheme without areas has its twin's error and little
// besides, so that the difference of both shows its limit dt -> 0 some ten times as sharply as the error itself does.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "experiments/common/coupled_increments.hpp"
#include "experiments/common/experiment.hpp"

namespace polhode {

/// Something whose strength is varied: a channel of the noise, the dissipation, or time (all of the drift).
struct direction {
  std::string name;
  int channel = -1;                   ///< whose increments are scaled
  std::unique_ptr<kernel> reference;  ///< of the system as it is, with more dissipation, or over longer steps
};

/// The driven equation over the steps of a grid.
struct driven_kernels {
  std::unique_ptr<kernel> truth;               ///< over the fine cells
  std::vector<std::unique_ptr<kernel>> twins;  ///< over the steps of each level
  std::vector<direction> directions;           ///< over those of the level of the responses
};

/// For any system: of its scene it changes the dissipation alone, and a system without has no such direction.
driven_kernels driven_kernels_of(const subject&, const level_grid&, int cells);

/// One block at a time.
class driven_block {
 public:
  /// looks: how often the truth is kept within a step of the coarsest level, at its equal parts; a power of two.
  driven_block(const context&, const level_grid&, int cells, noise_source, const driven_kernels&, int looks = 1);

  /// To time 0 of these paths.
  void start(std::uint64_t first_path);
  /// Through the chunk-th step of the coarsest level.
  void advance(int chunk);

  /// Of the last chunk; coarsest level first.
  const increment_view& increments(std::size_t level) const { return coupled_.level(level); }
  const increment_view& fine() const { return fine_; }

  const std::vector<double>& truth() const { return course_.back(); }
  /// On the way through the last chunk, at the end of each of its parts.
  std::span<const std::vector<double>> course() const { return course_; }
  const std::vector<double>& twin(std::size_t level) const { return twins_[level]; }
  /// d mu / d log(strength) of each direction, [component][lane], on the twin of a level a little coarser than the
  /// finest: what it is used for needs no more.
  std::vector<std::vector<double>> responses() const;

 private:
  void advance_varied(const increment_view&);

  const context& context_;
  coupled_increments coupled_;
  increment_view fine_;
  const driven_kernels& kernels_;
  std::uint64_t first_path_ = 0;
  std::vector<double> scaled_;
  std::vector<std::vector<double>> course_, twins_, varied_;
};

}  // namespace polhode
