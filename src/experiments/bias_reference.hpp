// What the stationary laws of schemes are compared with, and the difference that is asked for.
#pragma once

#include <optional>
#include <string>

#include "experiments/law_errors.hpp"
#include "experiments/transfer_report.hpp"

namespace polhode {

/// What is asked of a stationary law on the sphere: every observable that `select` judges, but the Casimir, which no
/// law there changes, and the square of h.
law_observables bias_observables(const subject&);

/// Coefficients in harmonics up to the degree, on the unit sphere: a column an observable.
Eigen::MatrixXd coefficients_of(const law_observables&, double radius, int degree);

/// The same on the basis of an operator.
Eigen::MatrixXd coefficients_on(const shell_basis&, const law_observables&);

struct bias_reference {
  std::vector<error_column> columns;
  transfer_question question;     ///< its answers: one a column
  Eigen::VectorXd uncertainty{};  ///< that is not in the question's answers, a column
  double widened = 1;             ///< times which their own uncertainty is taken
};

/// By the density itself: means of the observables, and how far the density is from the true one.
bias_reference bias_by_density(const subject&, const stationary_law&);

/// By the means of h and h^2, where the density is not known. Empty, with the reason, where these are not either.
std::optional<bias_reference> bias_by_means(const subject&, std::string& reason);

}  // namespace polhode
