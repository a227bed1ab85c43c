// SPDX-License-Identifier: Apache-2.0
// The transition test as verdicts: of one sphere or several, of one interval or several.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "experiments/common/recorder.hpp"
#include "recorded/followed_equation.hpp"
#include "recorded/transitions.hpp"

namespace polhode {

class transition_report {
 public:
  /// Keeps the subject by reference; its diffusion lives on a sphere.
  explicit transition_report(const subject&);

  void add(const recorded_transition&);
  /// Verdicts "transition law" and "energy law"; the equation that the data follow.
  followed_equation report(recorder&);

 private:
  transition_class* class_of(double radius, double dt);
  void report_transitions(const Eigen::VectorXd& residual, const Eigen::MatrixXd& variance, const followed_equation&,
                          recorder&) const;
  void report_energy(recorder&);

  const subject& subject_;
  std::vector<transition_class> classes_;
  double count_ = 0, dissipated_ = 0;  ///< transitions; sum of the rate of dissipation times the interval
  std::string reason_;                 ///< why nothing is asked; empty: it is
};

}  // namespace polhode
