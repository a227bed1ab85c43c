// SPDX-License-Identifier: Apache-2.0
// The spins of a scene, in either form of them.
#pragma once

#include <utility>

#include "problem/drives.hpp"
#include "problem/vectors.hpp"
#include "reports/model/scene.hpp"

namespace polhode {

template <class System, class Noise>
System spins_of(const report::scene& s, Noise noise) {
  return {matrix_of(s.vectors("quadratic")), three(s.vector("field")), matrix_of(s.vectors("exchange")),
          dissipation_of(s), std::move(noise)};
}

}  // namespace polhode
