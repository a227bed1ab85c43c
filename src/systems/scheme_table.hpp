// SPDX-License-Identifier: Apache-2.0
// All schemes as tapes: compiled once, for any system behind a face.
#pragma once

#include <string>
#include <vector>

#include <polhode/schemes/scheme_info.hpp>

#include "ensemble/tapes/tape.hpp"
#include "ensemble/tapes/taped_traits.hpp"

namespace polhode {

/// A scheme for any system behind a face.
struct scheme_row {
  scheme_info info;
  bool needs_areas;
  /// Why it does not apply to a system with these traits; empty where it does.
  std::string (*inapplicable)(const taped_traits&);
  /// The step size for which it wants the noise vectors of constant_noise::weak_order_two; 0: it takes them as they
  /// are.
  double (*weak_order_two_at)(double dt);
  /// Its tapes at a step size. components, tangents: of a state.
  scheme_tapes (*tapes)(const taped_traits&, int components, int tangents, double dt);
};

/// In the order of all_schemes.
const std::vector<scheme_row>& scheme_table();

/// The Wong-Zakai equation, which is no scheme of the list.
scheme_tapes wong_zakai_tapes(const taped_traits&, int components, double dt);

}  // namespace polhode
