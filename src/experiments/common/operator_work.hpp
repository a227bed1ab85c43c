// SPDX-License-Identifier: Apache-2.0
// How long operators on a sphere take: an expectation, for forecasts.
#pragma once

#include "experiments/common/experiment.hpp"

namespace polhode {

/// Processor seconds of one scheme's operators, as runs have taken them on spheres of three kinds: smooth laws, of
/// which few moments are asked without noise; noise along one direction alone; a field or noise that depends on the
/// state, where a step is longer as well.
inline double by_sphere(const subject& s, double smooth, double one_direction, double in_field) {
  constexpr double without_noise = 0.2;
  if (s.model->noise() == noise_class::none) return without_noise * smooth;
  if (s.model->noise() == noise_class::state_dependent || s.sphere()->has_field()) return in_field;
  return s.model->noise() == noise_class::one_vector ? one_direction : smooth;
}

}  // namespace polhode
