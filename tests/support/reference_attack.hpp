// SPDX-License-Identifier: Apache-2.0
// Random and extreme scenes against the references: every answer is compared with second opinions.
//
//   gibbs         Gauss-Legendre about another axis, long double     for Gauss-Kronrod about the axis of least energy
//   mean          Gibbs law, trace, Fourier collocation              for Poisson's equation
//   expectation   one dimension, time series in fifty digits,        for the Taylor action and its remainder
//                 Fourier collocation
//   gap           one dimension, Fourier collocation                 for inverse iteration and three degrees
//   lyapunov      a diffusion of (v, w, x)_figure by collocation     for Poisson's equation and three degrees
//
// and, besides, projections on about twice the degree. Wrong is what differs by more than both bars together.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "support/second_opinions.hpp"

namespace polhode::test {

struct attack_count {
  int tried = 0, answered = 0, refused = 0, checked = 0, apart = 0, wrong = 0;  ///< apart: by another kind of method
  double worst = 0;            ///< what no second opinion's bar explains, over the answer's
  std::vector<double> sees{};  ///< of every answer checked, the least error that its sharpest check shows, relative
  double slowest = 0;          ///< the dearest answer or refusal, in seconds of processor time
};

reference_value asked(const std::string& quantity, const attacked_scene&, const std::string& observable);
opinions opinions_on(const std::string& quantity, const attacked_scene&, const std::string& observable,
                     const reference_value& found, bool dear);
void count_answer(attack_count&, const std::string& what, const attacked_scene&, const reference_value& found,
                  const opinions& seconds);

/// Asks and checks one quantity: gibbs, mean, expectation, gap or lyapunov. dear: by second opinions that take seconds
/// too. Only expectations are of other observables than energy.
void attack(const std::string& quantity, const attacked_scene&, attack_count&, bool dear,
            const std::string& observable = "energy");

std::string attack_table(const std::map<std::string, attack_count>&);

}  // namespace polhode::test
