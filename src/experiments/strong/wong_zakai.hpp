// SPDX-License-Identifier: Apache-2.0
// How far is the reference itself from the solution?
//
// Experiment strong compares with Y_d, the solution driven by the piecewise linear path of cells of width d, which
// tends to the Stratonovich solution X: Wong, Zakai, Ann. Math. Stat. 36 (1965) 1560-1564. Its order g in mean square
// is 1/2, as of all that know no areas inside a cell (Clark, Cameron, Lect. Notes Control Inf. Sci. 25 (1980) 162-171),
// and 1 where the noise commutes. The twins (driven_block.hpp) are Y at the steps of the levels, so that
// D_d = |Y_d - Y_{d/2}| is measured there and D_d ~ a d^g extrapolated to the reference's own cells:
//
//   |Y_d - X| <= sum_k D_{d / 2^k} = D_d / (1 - 2^-g)
#pragma once

#include "experiments/common/driven_block.hpp"
#include "experiments/common/recorder.hpp"
#include "statistics/orders/order_fit.hpp"

namespace polhode {

/// |Y_d - Y_{d/2}|^2 of each path at the end, d the steps of all levels but the finest.
struct halved_references {
  squared_errors squares;
  halved_references(int paths, int levels)
      : squares{paths, levels - 1, std::vector<double>(static_cast<std::size_t>(paths * (levels - 1)))} {}
  void keep(const driven_block& at_the_end, int first_path);
};

struct reference_distance {
  std::optional<order_fit> decay;  ///< of D
  interval_estimate halved;        ///< D at the reference's cells, 95 %
  interval_estimate bound;         ///< the sum above; of the claimed order g
};

/// dt: steps of the levels but the finest; order: g; cell: width of the reference's cells.
reference_distance distance_of_reference(std::span<const double> dt, const halved_references&, double order,
                                         double cell, std::uint64_t seed);

void report_reference(const reference_distance&, std::span<const double> dt, const halved_references&, double order,
                      double cell, double size, recorder&);

}  // namespace polhode
