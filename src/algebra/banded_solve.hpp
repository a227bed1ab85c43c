// SPDX-License-Identifier: Apache-2.0
// Linear equations whose matrix couples near indices alone, such as a Galerkin operator ordered by degree.
#pragma once

#include <optional>

#include "algebra/sparse_blocks.hpp"

namespace polhode {

/// x of a x = right, by elimination over dense blocks: a is block tridiagonal under the finest cut of its indices into
/// runs that talk to their neighbours alone. Rows change places within a block only, so a solution is as good as what
/// is left of right - a x, which the caller looks at. Empty if a block is singular, or the solution not finite.
///
/// Cost: 8/3 n^3 for each block of n; a general sparse factorisation of such blocks (full, once eliminated) pays as
/// much and its bookkeeping.
std::optional<Eigen::VectorXd> banded_solve(const sparse_matrix& a, const Eigen::VectorXd& right);

}  // namespace polhode
