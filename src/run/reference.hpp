// SPDX-License-Identifier: Apache-2.0
// Exact answers about a scene: expectations, the stationary law, the spectral gap, Lyapunov exponents. No sampling.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "scene/scene.hpp"

namespace polhode {

/// Beyond it nothing is affordable.
inline constexpr int most_reference_degree = 128;

struct reference_options {
  std::string quantity;                   ///< expectation, gibbs, lyapunov or gap
  std::optional<std::string> observable;  ///< of expectation and gibbs, see system_entry; energy if absent
  std::optional<double> time;             ///< of expectation; the scene's horizon if absent
  int degree = 0;                         ///< of the harmonics; 0: chosen by the program
};

struct reference_answer {
  std::string quantity, observable;  ///< the observable is empty where none is asked for
  std::optional<double> time;
  double value = 0, uncertainty = 0;
  int degree = 0;                        ///< 0: a closed form, or the one path without noise
  std::optional<double> sum, dimension;  ///< of the Lyapunov exponents
  std::string method;                    ///< one sentence
  std::string reason;                    ///< why it is not as certain as intended; empty: it is
};

/// Without noise the expectation is the one question that remains: it is answered whatever was asked, and `reason` says
/// so. Throws input_error for what cannot be asked of the scene.
reference_answer reference(const scene&, const reference_options&);

}  // namespace polhode
