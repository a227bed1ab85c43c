// SPDX-License-Identifier: Apache-2.0
#include "ensemble/tapes/tape_kernel.hpp"

#include <Eigen/LU>
#include <utility>

#include "ensemble/tapes/tape_kernel_entries.hpp"
#include "platform/isa_entry.hpp"

namespace polhode {

std::unique_ptr<kernel> tape_kernel(std::shared_ptr<const face> values, std::shared_ptr<const face> tangents,
                                    scheme_tapes tapes) {
  std::unique_ptr<kernel> out;
  by_isa(POLHODE_ENTRIES(polhode_tape_kernel_))({std::move(values), std::move(tangents), std::move(tapes)}, out);
  return out;
}

std::unique_ptr<tangent_kernel> tape_tangent_kernel(std::shared_ptr<const face> tangents, scheme_tapes tapes) {
  std::unique_ptr<tangent_kernel> out;
  by_isa(POLHODE_ENTRIES(polhode_tape_tangent_kernel_))({nullptr, std::move(tangents), std::move(tapes)}, out);
  return out;
}

void inverse_derivative_by_lanes(const double* slope, int n, int lanes, double* out) {
  const auto at = [&](int row, int column, int lane) { return (row * n + column) * lanes + lane; };
  for (int lane = 0; lane < lanes; ++lane) {
    Eigen::MatrixXd m(n, n);
    for (int row = 0; row < n; ++row)
      for (int k = 0; k < n; ++k) m(row, k) = (row == k ? 1 : 0) - slope[at(row, k, lane)] / 2;
    const Eigen::MatrixXd inverted = m.partialPivLu().inverse();
    for (int row = 0; row < n; ++row)
      for (int k = 0; k < n; ++k) out[at(row, k, lane)] = inverted(row, k);
  }
}

}  // namespace polhode
