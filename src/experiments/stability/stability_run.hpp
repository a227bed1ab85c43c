// SPDX-License-Identifier: Apache-2.0
// Many paths of one scheme at one step size, watched until they break.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "experiments/stability/breakage.hpp"
#include "experiments/stability/stability_case.hpp"

namespace polhode {

struct stability_plan {
  double dt = 0;
  std::int64_t steps = 0;
  int paths = 0;
  std::uint64_t seed = 0;
  noise_generator generator = noise_generator::philox;
  bool to_the_end = false;  ///< count every path that breaks; else stop where too many have
  block_listener hear = {};
};

struct stability_outcome {
  int paths = 0, broken = 0;        ///< paths: how many were run
  breakage first = breakage::none;  ///< of the run: what the most paths broke by, else mean_energy
  double mean_energy = 0;           ///< over the paths that are whole
  double worst_casimir = 0;         ///< relative; infinite where a path of an explicit scheme was lost
  double worst_energy = 0;          ///< excess over the range of h, relative to its greatest
  double least_energy = HUGE_VAL, greatest_energy = -HUGE_VAL;  ///< seen on paths that are whole

  void see(double least, double greatest) {
    least_energy = std::min(least_energy, least);
    greatest_energy = std::max(greatest_energy, greatest);
  }

  bool stable() const { return first == breakage::none; }
};

/// A function of its arguments: paths are addressed by the number of steps, so that runs of different dt share none.
stability_outcome run_until_broken(const stability_case&, const scheme_entry&, const stability_plan&);

/// One of many runs of as many steps.
struct stability_member {
  const stability_case* in;
  const scheme_entry* scheme;
  double dt;
  block_listener hear = {};
};

/// What run_until_broken gives each of them alone, bit for bit, but their noise is drawn once for all. The dt and the
/// listener of the plan do not count; the noise of all cases has as many channels.
std::vector<stability_outcome> run_until_broken(std::span<const stability_member>, const stability_plan&);

/// The Wong-Zakai equation, 16 steps to a time scale: its mean energy at the horizon and the energies on the way.
stability_outcome true_paths(const stability_case&, int paths, std::uint64_t seed, noise_generator,
                             const block_listener& hear = {});

}  // namespace polhode
