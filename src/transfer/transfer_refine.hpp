// SPDX-License-Identifier: Apache-2.0
// How finely a transfer operator has to be computed, found by refining until answers stop to change.
//
// The basis, the nodes a channel and the nodes an area are refined each with the others at their coarsest, as the error
// of one hardly knows of the others, until two successive answers agree. The answer is that of all together, each as it
// was before its last refinement, with the last change by the basis added; its uncertainty the sum of the last changes.
#pragma once

#include <Eigen/Core>

#include "transfer/transfer_question.hpp"

namespace polhode {

class operator_store;

struct transfer_answer {
  Eigen::VectorXd error, uncertainty;  ///< of the answers less the exact ones
  bool resolved = false;               ///< to the tolerance
  transfer_rule rule{};                ///< by which the answer was found
  double taken_back = 0;               ///< bound on the probability that a path is taken back to the shell
  Eigen::VectorXd by_basis{};          ///< of the uncertainty: the last change with the basis
};

/// Of a scheme that leaves the sphere: in the law of its paths without those that are taken back to the shell (rejected
/// as by Milstein and Tretyakov; the moments of all need not exist). Their probability times the range of what is
/// averaged, four times its scale, is part of the uncertainty. kept: where operators on the sphere are looked up, and
/// kept; null: nowhere.
transfer_answer refine(const subject&, const scheme_entry&, double dt, std::int64_t steps, const transfer_question&,
                       operator_store* kept = nullptr);

/// The same of the exponents of a scheme that keeps the sphere: lambda_1 and lambda_1 + lambda_2. Degrees up to
/// most_frame_degree (transfer/frame_sums.hpp).
transfer_answer refine_exponents(const subject&, const scheme_entry&, double dt, const transfer_target&);

}  // namespace polhode
