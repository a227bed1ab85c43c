// SPDX-License-Identifier: Apache-2.0
// One run of the experiment on stability, block by block and chunk by chunk: who drives it brings the noise.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "ensemble/noise/paths.hpp"
#include "ensemble/observing/running_moments.hpp"
#include "experiments/stability/stability_run.hpp"

namespace polhode {

/// One block of paths and what has broken each of them.
class watched_block {
 public:
  watched_block(const stability_case& c, bool implicit)
      : states(replicated(c.bound.scene.momentum)),
        case_(c),
        implicit_(implicit),
        casimirs_(c.casimirs.size() * block_lanes) {}

  std::vector<double> states;
  std::array<breakage, block_lanes> broken{};

  /// At the energy and the Casimirs of all paths.
  void look(stability_outcome&);
  double energy(std::size_t lane) const { return energy_[lane]; }

 private:
  const stability_case& case_;
  bool implicit_;
  std::array<double, block_lanes> energy_{};
  lane_vector<double> casimirs_;  ///< [casimir][lane]

  /// Of the Casimir of that number, relative.
  double off(std::size_t i, double casimir) const;
  /// The largest of all Casimirs; NaN where one is no number. Where |mu| may grow without bound, rounding of a Casimir
  /// is that of what it is made of now.
  double off(std::size_t lane) const;
  double beyond(double h) const;

  /// What is nearly always so, by the extremes alone. NaN is in no order, but a sum keeps it.
  bool all_whole(stability_outcome&) const;

  /// On a sphere |Pi| = 0 is no rounding: its square has vanished, and with it every direction.
  breakage judge(std::size_t lane, stability_outcome&) const;
};

/// One scheme in one case.
class watched_run {
 public:
  /// Of what is given by reference it keeps the reference.
  watched_run(const stability_case&, const kernel&, bool implicit, bool areas, block_listener, const stability_plan&);

  /// Whether it needs that block, all before it being done.
  bool wants(int block) const;
  void begin();
  void advance(std::int64_t first_step, const increment_view&);
  /// Nothing more can be learned from this block.
  bool over() const { return over_; }
  void end();

  double dt() const { return step_.dt(); }
  bool needs_areas() const { return areas_; }
  stability_outcome outcome() const;

 private:
  const stability_case& case_;
  const kernel& step_;
  bool implicit_, areas_;
  block_listener hear_;
  const stability_plan& plan_;
  stability_outcome out_;
  std::array<int, 6> counts_{};
  running_moments energy_;
  std::optional<watched_block> block_;
  int before_ = 0;
  bool over_ = false;
};

}  // namespace polhode
