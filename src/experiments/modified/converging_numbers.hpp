// SPDX-License-Identifier: Apache-2.0
// Numbers of the equation that those of a scheme converge to at its weak order, as power series in dt.
#pragma once

#include <string>

#include "experiments/laws/law_averages.hpp"
#include "experiments/laws/transfer_report.hpp"

namespace polhode {

struct converging_numbers {
  std::string claim, quantity;  ///< of the verdict; of the measurements, the errors over dt
  exact_averages exact;         ///< names, values other than zero and their uncertainty
};

/// Measurements over dt, fits, and the verdict: of the relative errors (columns `first` … of the table) all
/// coefficients below dt^order have to vanish (the truth's uncertainty, the same at every dt, is the first one's),
/// within intervals below a thousandth at the coarsest dt.
void report_convergence(const converging_numbers&, const error_table&, Eigen::Index first, int order, recorder&);

}  // namespace polhode
