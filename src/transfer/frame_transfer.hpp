// SPDX-License-Identifier: Apache-2.0
// A scheme's own operator on tangent directions: (T f)(R) = E[f(R')], R' the frame to which one step and its derivative
// take the frame R, without sampling. The law that T leaves as it is gives the scheme's own Lyapunov exponents:
//
//   lambda_1 = E_law E[log |D Phi v|] / dt,   lambda_1 + lambda_2 = E_law E[log |det D Phi|] / dt
//
// (Furstenberg and Khasminskii), D Phi the derivative between the tangent planes of the sphere. Quadrature over the
// noise and projection as in transfer.hpp, on the functions of frame_basis.hpp.
#pragma once

#include "problem/subject.hpp"
#include "transfer/basis/frame_basis.hpp"
#include "transfer/basis/transfer_rule.hpp"

namespace polhode {

struct frame_transfer {
  double dt;
  Eigen::MatrixXd matrix;                      ///< T F_j = sum_i matrix(i, j) F_i
  Eigen::VectorXd length_growth, area_growth;  ///< coefficients of E[log |D Phi v|] and of E[log |det D Phi|]

  /// lambda_1 and lambda_1 + lambda_2; not finite where a step of the scheme is not.
  Eigen::Vector2d exponents() const;
};

/// Of a scheme that keeps the sphere. rule.basis: its degree <= most_frame_degree alone counts.
frame_transfer make_frame_transfer(const subject&, const scheme_entry&, double dt, const transfer_rule&);

/// Its exponents alone. Where a step and its derivative commute with the half turns of the body (half_turns.hpp; tried
/// out at some points and all nodes) the invariant functions are enough: the law is the only one, and so invariant.
Eigen::Vector2d discretisation_exponents(const subject&, const scheme_entry&, double dt, const transfer_rule&);

}  // namespace polhode
