// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set. Memory that Eigen takes here it gives back here: its alignment is another
// elsewhere.
#include "algebra/dense_algebra.hpp"

#include <Eigen/LU>

#include "platform/isa_entry.hpp"

namespace polhode {
namespace {

using columns = Eigen::Map<Eigen::MatrixXd, Eigen::Unaligned, Eigen::OuterStride<>>;

columns mapped(const dense_columns& a) { return {a.at, a.rows, a.columns, Eigen::OuterStride<>(a.stride)}; }

}  // namespace
}  // namespace polhode

extern "C" void POLHODE_ENTRY(polhode_add_product_)(const polhode::dense_product& p) {
  using polhode::mapped;
  if (p.transposed)
    mapped(p.c).noalias() += mapped(p.a).transpose() * mapped(p.b);
  else
    mapped(p.c).noalias() += mapped(p.a) * mapped(p.b);
}

// Right sides become solutions. LU of a^T: a left solution is one of it.
extern "C" void POLHODE_ENTRY(polhode_solve_)(const polhode::dense_columns& a,
                                              const polhode::dense_columns& right_sides) {
  auto x = polhode::mapped(right_sides);
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(polhode::mapped(a).transpose());
  x = lu.solve(x).eval();
}
