// How finely a transfer operator has to be computed, found by refining until answers stop to change.
//
// The basis, the nodes a channel and the nodes an area are refined each with the others at their coarsest, as the error
// of one hardly knows of the others, until two successive answers agree. The answer is that of all together, its
// uncertainty the sum of the last changes.
#pragma once

#include <functional>

#include "experiments/transfer.hpp"

namespace polhode {

/// Numbers that an operator answers, and what they are compared with.
struct transfer_question {
  std::function<Eigen::VectorXd(const transfer_operator&)> ask;
  Eigen::VectorXd exact, scale;  ///< scale: the size of what is averaged, by which errors of several are compared
  double tolerance = 1e-4;       ///< of each error, or of a tenth of the largest
};

struct transfer_answer {
  Eigen::VectorXd error, uncertainty;  ///< of the answers less the exact ones
  bool resolved = false;               ///< to the tolerance
};

transfer_answer refine(const subject&, const scheme_entry&, double dt, std::int64_t steps, const transfer_question&);

}  // namespace polhode
