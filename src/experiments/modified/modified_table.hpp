// SPDX-License-Identifier: Apache-2.0
// Effective parameters of a scheme at several step sizes: the rigid body whose generator is nearest to log(T_dt)/dt.
#pragma once

#include <array>
#include <string_view>

#include "experiments/laws/transfer_report.hpp"
#include "experiments/modified/discretisation_gap.hpp"
#include "experiments/modified/ergodic_variance.hpp"
#include "sphere/generator_family.hpp"

namespace polhode {

/// Columns of the tables: what an operator's generator is made of, as differences from the scene, and the residual.
struct modified_columns {
  static constexpr Eigen::Index count = 13, residual = 12;
  static const std::array<std::string_view, count>& names();

  Eigen::VectorXd exact;  ///< the scene's k and theta k, each less its mean, Q_11, Q_12, Q_13, Q_22, Q_23, Q_33, and 0
  Eigen::VectorXd unit;   ///< all rates together, in units of each column; of the residual 1
  Eigen::VectorXd scale;  ///< the norms of k, theta k and Q, each at least a hundredth of the unit
};
modified_columns columns_on(const sphere_problem&);

/// No uncertainty is less than that of a difference, whatever two refinements agree on (modified_table.cpp).
inline constexpr double unseen_share = 1.75e-6;

/// Steps at which the logarithm is looked for: dt times the fastest rate from 0.3 down to a hundredth, numbers
/// of steps that are the scene's fewest times a power of two.
level_grid modified_levels(const subject&);

/// Differences from the scene and their uncertainty [level][column], of every scheme, at the coarsest seven of the
/// levels at which the logarithm is found. Behind the columns those of the averages: of the law after the horizon's
/// steps, of the stationary one, the asymptotic variances, and the spectral gap; the last asks for no refinement of its
/// own.
std::vector<error_table> modified_tables(const context&, const std::vector<scheme_entry>&, const modified_columns&,
                                         const law_averages&, const exact_averages& variances, const known_gap& known);

}  // namespace polhode
