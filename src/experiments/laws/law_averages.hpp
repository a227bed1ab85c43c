// SPDX-License-Identifier: Apache-2.0
// Averages that are known exactly, at the horizon and under the stationary law, and what a transfer operator makes of
// them.
#pragma once

#include <string>
#include <vector>

#include "transfer/transfer.hpp"

namespace polhode {

struct exact_averages {
  std::vector<std::string> names;  ///< of observables
  std::vector<sphere_function> functions;
  Eigen::VectorXd value, uncertainty, size;  ///< size: root mean square over the sphere
  int degree = 0;                            ///< of the harmonics that the values took

  Eigen::Index count() const { return value.size(); }
};

struct law_averages {
  exact_averages at_horizon, stationary;  ///< each of those observables whose average has converged
  std::string no_horizon, no_law;         ///< why there are none; else empty

  Eigen::Index count() const { return at_horizon.count() + stationary.count(); }
  Eigen::VectorXd value() const { return joined(at_horizon.value, stationary.value); }
  Eigen::VectorXd uncertainty() const { return joined(at_horizon.uncertainty, stationary.uncertainty); }
  Eigen::VectorXd size() const { return joined(at_horizon.size, stationary.size); }
  /// The operator's own: after so many steps from the start, then of its stationary law.
  Eigen::VectorXd of(const transfer_operator&, const Eigen::Vector3d& start, std::int64_t steps) const;

 private:
  static Eigen::VectorXd joined(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    Eigen::VectorXd out(a.size() + b.size());
    out << a, b;
    return out;
  }
};

law_averages averages_on(const subject&);

}  // namespace polhode
