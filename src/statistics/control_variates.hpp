// SPDX-License-Identifier: Apache-2.0
// Less variance by what is known to vanish in the mean.
//
// Y_1 … Y_k have mean 0 for every path, so y - sum b_j Y_j has the mean of y for any b; least squares finds the b of
// least variance. The coefficients for one half of the paths come from the other half, so that they are independent of
// what they multiply and the mean stays exactly unbiased. (Standard; Glasserman, Monte Carlo Methods in Financial
// Engineering (2003), section 4.1.)
#pragma once

#include <Eigen/Core>

namespace polhode {

/// y - Y b, path by path; paths x controls. Controls that are not there (zero columns) and dependent ones are harmless.
/// Anything not finite spreads to all paths of the other half.
Eigen::MatrixXd all_controlled(const Eigen::MatrixXd& y, const Eigen::MatrixXd& controls);  ///< each column of y
Eigen::VectorXd controlled(const Eigen::VectorXd& y, const Eigen::MatrixXd& controls);

/// The means of the controls against their standard errors, as normal deviates of Student's law; controls that are not
/// there are left out. Where one is not zero, neither is what taking the controls out adds to the mean.
struct control_means {
  int count = 0;
  double largest = 0;  ///< by size, with its sign; not finite where a control is not
};
control_means means_of_controls(const Eigen::MatrixXd& controls);

}  // namespace polhode
