// SPDX-License-Identifier: Apache-2.0
// What is asked of a transfer operator, and how well it is to be known.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

#include "transfer/transfer.hpp"

namespace polhode {

/// What the numbers that an operator answers are compared with.
struct transfer_target {
  Eigen::VectorXd exact, scale;  ///< scale: the size of what is averaged, by which errors of several are compared
  double tolerance = 1e-4;       ///< of each error, or of a tenth of the largest
  Eigen::Index deciding = 0;     ///< of that many answers, the first; 0: of all. The others are answered as they come
};

/// The numbers, of momentum's operator.
struct transfer_question {
  std::function<Eigen::VectorXd(const transfer_operator&)> ask;
  transfer_target target;
  std::string name{};  ///< of what is asked: a name that an operator_store knows has the answers that it had
};

}  // namespace polhode
