// SPDX-License-Identifier: Apache-2.0
// The semigroup of a generator on the functions of one degree, with a proved bar.
#pragma once

#include <functional>
#include <optional>

#include "algebra/sparse_blocks.hpp"
#include "sphere/galerkin/poisson.hpp"
#include "sphere/galerkin/raise_degree.hpp"

namespace polhode {

/// Bounds of suprema from coefficients.
struct suprema_of_basis {
  supremum_bound inside;  ///< of the functions of the degree, the constant first
  supremum_bound beyond;  ///< of those of the next two degrees
  double unit_of_mean;    ///< a constant's coefficient over its value
};

struct propagated_value {
  projected_value found;
  bool relaxed;  ///< before the time was over
};

/// (exp(time A) f)(y). tall: the generator A from the functions of one degree to those two degrees higher; y: the
/// values of the functions at the start. The remainder (A - A_L) g of the Galerkin solution g, summed over the time,
/// bounds its error, as the semigroup is a contraction in the supremum norm. Once g is a constant but for rounding it
/// stays one: there it ends. Nothing where that takes more than seconds.
std::optional<propagated_value> propagated(const sparse_matrix& tall, const Eigen::VectorXd& f,
                                           const Eigen::VectorXd& y, double time, const suprema_of_basis&);

}  // namespace polhode
