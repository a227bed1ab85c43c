// SPDX-License-Identifier: Apache-2.0
// Where tests break the noise on its way to the kernels: nothing else plants a defect, and without one nothing changes.
//
//   struct too_strong : noise_defect {
//     void spoil(const drawn_noise& n) const override {
//       if (n.coarsened) return;                        // its fine increments were spoilt before
//       for (double& x : n.dw) x *= 1.02;               // precise normals, and those of one common path
//       for (float& x : n.singles) x *= 1.02f;          // fast normals, before their scale
//     }
//   };
//   const too_strong defect;
//   const planted_noise_defect planted(defect);         // for every run until the end of the scope
#pragma once

#include <cstdint>
#include <span>

#include "ensemble/noise/noise_layout.hpp"

namespace polhode {

/// Numbers just drawn, [step][channel][lane] and [step][pair][lane]; lanes: block_lanes, or 1 where one path drives
/// all. Either dw (in units of time^1/2) or singles (standard normals); area: empty where nobody asks for areas.
struct drawn_noise {
  std::uint64_t first_path, first_step;
  int lanes, steps;
  noise_layout layout;
  double dt;
  std::span<double> dw;
  std::span<float> singles;
  std::span<double> area;
  bool coarsened = false;  ///< by Chen's relation from fine increments that passed here before
};

class noise_defect {
 public:
  virtual ~noise_defect() = default;
  /// The path (the first of a block, or the one of a common noise) whose numbers are drawn in place of its own.
  virtual std::uint64_t path(std::uint64_t own) const { return own; }
  virtual void spoil(const drawn_noise&) const {}
};

/// In force in the whole process; plant before a run and not during one.
class planted_noise_defect {
 public:
  explicit planted_noise_defect(const noise_defect&);
  ~planted_noise_defect();
  planted_noise_defect(const planted_noise_defect&) = delete;
  planted_noise_defect& operator=(const planted_noise_defect&) = delete;
};

/// Null but in tests.
const noise_defect* noise_defect_in_force();

}  // namespace polhode
