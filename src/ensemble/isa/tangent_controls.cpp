// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set.
#include "ensemble/tangent_controls.hpp"

#include <polhode/scalar.hpp>

#include "ensemble/kernel_of.hpp"
#include <polhode/flatten.hpp>
#include "platform/isa_entry.hpp"

namespace polhode {
namespace {

void add_next(double*& sums, const pack& x) {
  pack(pack(sums, stdx::element_aligned) + x).copy_to(sums, stdx::element_aligned);
  sums += block_lanes;
}

vec<pack, 3> noise_of(const tangent_controls& q, int lane) {
  const auto dw = load_increment<pack, 3>(q.step, lane);
  vec<pack, 3> out;
  for (int i = 0; i < 3; ++i) {
    const double* const row = q.sigma.data() + 3 * i;
    out[i] = row[0] * dw[0] + row[1] * dw[1] + row[2] * dw[2];
  }
  return out;
}

void add_controls(const tangent_controls& q, int lane) {
  const auto x = load_lanes<pack, 3>(q.states + lane), v = load_lanes<pack, 3>(q.tangents + lane);
  const auto b = noise_of(q, lane);
  const auto w = cross(x, v), unit = pack(1 / dot(v, v)) * v;
  double* to = q.sums + lane;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const auto covariance = [&](int row, int column) {
      return q.dt * q.covariance[static_cast<std::size_t>(3 * row + column)];
    };
    const auto difference = [&](const auto& y, const auto& z) { return pack(y[j] * z[j] - y[k] * z[k]); };
    const pack xx = difference(x, x), vv = difference(unit, v), vw = difference(unit, w), xv = difference(x, v);
    const pack excess = b[i] * b[i] - covariance(i, i), both = b[j] * b[k] - covariance(j, k);
    const pack x_jk = x[j] * x[k], v_jk = unit[j] * v[k], vw_jk = unit[j] * w[k], vw_kj = unit[k] * w[j];
    add_next(to, b[i] * x_jk);
    add_next(to, b[i] * v_jk);
    add_next(to, b[i] * (vw_jk + vw_kj));
    add_next(to, excess * xx);
    add_next(to, excess * vv);
    add_next(to, excess * vw);
    add_next(to, both * x_jk);
    add_next(to, both * v_jk);
    add_next(to, both * vw_jk);
    add_next(to, both * vw_kj);
    add_next(to, b[i] * x[i] * xx);
    add_next(to, b[i] * x[i] * vv);
    add_next(to, b[i] * x[i] * vw);
    add_next(to, b[i] * unit[i] * xv);
    add_next(to, b[i] * unit[i] * difference(x, w));
    add_next(to, b[i] * w[i] * difference(x, unit));
  }
}

}  // namespace
}  // namespace polhode

extern "C" POLHODE_FLATTEN void POLHODE_ENTRY(polhode_add_controls_)(const polhode::tangent_controls& q) {
  for (int lane = 0; lane < polhode::block_lanes; lane += static_cast<int>(polhode::pack::size()))
    polhode::add_controls(q, lane);
}
