// SPDX-License-Identifier: Apache-2.0
// What the stationary laws of schemes are compared with, and the difference that is asked for.
#pragma once

#include <optional>
#include <string>

#include "experiments/laws/law_errors.hpp"
#include "experiments/laws/transfer_report.hpp"
#include "sphere/stationary.hpp"

namespace polhode {

inline constexpr double bias_tolerance = 5e-4;  ///< to which an error is to be known

/// What is asked of a stationary law on the sphere: every observable that `select` judges, but the Casimir, which no
/// law there changes, and the square of h.
law_observables bias_observables(const subject&);

/// Coefficients in harmonics up to the degree, on the unit sphere: a column an observable.
Eigen::MatrixXd coefficients_of(const law_observables&, double radius, int degree);

/// The same on the basis of an operator.
Eigen::MatrixXd coefficients_on(const shell_basis&, const law_observables&);

/// Answers of `question`: one a column, then, where it has as many more, how far each of these is known on the degree
/// of the operator: that takes the place of the last change with the degree.
struct bias_reference {
  std::vector<error_column> columns;
  transfer_question question;
  Eigen::VectorXd uncertainty{};  ///< that is not in the question's answers, a column

  transfer_answer of(const subject&, const scheme_entry&, double dt, std::int64_t steps) const;
  Eigen::VectorXd change_by_far_noise(const subject&, const scheme_entry&, double dt, std::int64_t steps) const;
};

/// By the density itself: means of the observables, and how far the density is from the true one.
bias_reference bias_by_density(const subject&, const stationary_law&);

/// Where the density is not known, by the difference of two laws on harmonics of one degree, the scheme's and the
/// equation's. Neither is resolved there. But the operator of a short step and the generator lack the same harmonics:
/// P exp(dt L) P = 1 + dt P L P + …, so what the degree does to both means is the same but for O(dt^p), and their
/// difference settles earlier than either. How far it is known: difference_bar.hpp. Empty, with the reason, where the
/// mean of h itself is not known roughly.
std::optional<bias_reference> bias_by_difference(const subject&, const stationary_law&, std::string& reason);

}  // namespace polhode
