// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set: powers of the frame's half turns, then the recurrence in the degree.
#include "transfer/frame_sums.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

#include <polhode/scalar.hpp>

#include "ensemble/kernel_of.hpp"
#include <polhode/flatten.hpp>
#include "platform/isa_entry.hpp"
#include "transfer/basis_sums.hpp"

namespace polhode {
namespace {

struct complex_pack {
  pack re, im;
  complex_pack operator*(const complex_pack& o) const { return {re * o.re - im * o.im, re * o.im + im * o.re}; }
};

/// z, or its conjugate for a negative power.
complex_pack turned(const complex_pack& z, int power) { return power < 0 ? complex_pack{z.re, -z.im} : z; }

/// Monomials of an even number of factors, which alone are functions of the rotation, in its Cayley-Klein parameters
/// a = cos(beta/2) exp(i (alpha+gamma)/2) and b = sin(beta/2) exp(i (alpha-gamma)/2) (frame_basis.hpp).
class half_turns {
 public:
  half_turns(const vec<pack, 3>& v, const vec<pack, 3>& w, const vec<pack, 3>& x, int degree)
      : with_b_{0.5 * x[0], 0.5 * x[1]}, with_conjugate_{-0.5 * v[2], 0.5 * w[2]} {
    a_[0] = b_[0] = {pack(1.0), pack(0.0)};
    const complex_pack aa{0.5 * (v[0] + w[1]), 0.5 * (v[1] - w[0])}, bb{0.5 * (w[1] - v[0]), -0.5 * (v[1] + w[0])};
    for (std::size_t k = 1; k <= static_cast<std::size_t>(degree); ++k) {
      a_[k] = a_[k - 1] * aa;
      b_[k] = b_[k - 1] * bb;
    }
  }
  /// a^(m+n) b^(m-n), n >= 0, a negative power being that of the conjugate.
  complex_pack operator()(int m, int n) const {
    const int p = m + n, q = m - n;
    const auto product = turned(a_[static_cast<std::size_t>(std::abs(p) / 2)], p) *
                         turned(b_[static_cast<std::size_t>(std::abs(q) / 2)], q);
    if (p % 2 == 0) return product;
    return product * (q < 0 && p > 0 ? with_conjugate_ : turned(with_b_, p));
  }

 private:
  complex_pack with_b_, with_conjugate_;  // a b and a conj(b)
  std::array<complex_pack, most_frame_degree + 1> a_, b_;
};

void add_to(double*& at, const pack& value) {
  pack sum;
  sum.copy_from(at, stdx::element_aligned);
  sum += value;
  sum.copy_to(at, stdx::element_aligned);
  at += sum_lanes;
}

/// A frame and its weight.
struct weighted_frame {
  half_turns turns;
  pack z;
  double weight;
};

/// Of several frames at a time: their recurrences hide each other's latency, and the sums are touched once.
template <std::size_t count>
void add_functions(const frame_sums& q, const std::array<weighted_frame, count>& frames, double* sums) {
  const double* factor = q.recurrence;
  std::array<complex_pack, count> power;
  std::array<pack, count> p, before;
  const int most = q.degree - q.degree % q.m_step;
  for (int n = 0; n <= q.degree; n += 2)
    for (int m = n == 0 ? 0 : -most; m <= most; m += q.m_step) {
      const double highest = *factor++;
      for (std::size_t i = 0; i < count; ++i) {
        power[i] = frames[i].turns(m, n);
        p[i] = pack(frames[i].weight * highest);
        before[i] = pack(0.0);
      }
      for (int l = std::max(std::abs(m), n); l <= q.degree; ++l, factor += 3) {
        pack re(0.0), im(0.0);
        for (std::size_t i = 0; i < count; ++i) {
          re += power[i].re * p[i];
          im += power[i].im * p[i];
          const pack next = (factor[0] * frames[i].z + factor[1]) * p[i] - factor[2] * before[i];
          before[i] = p[i];
          p[i] = next;
        }
        add_to(sums, re);
        if (m != 0 || n != 0) add_to(sums, im);
      }
    }
}

pack reciprocal_length(const pack& square) { return pack(1.0) / square_root(square); }

/// Adds the growth of that direction, and returns the frame that it is mapped to.
weighted_frame mapped(const frame_sums& q, int node, int angle, int lane) {
  constexpr int block = 3 * block_lanes;
  const double weight = q.weights[node];
  const double* const tangents = q.tangents + node * 2 * block + lane;
  const auto pi = load_lanes<pack, 3>(q.states + node * block + lane), v = load_lanes<pack, 3>(tangents),
             w = load_lanes<pack, 3>(tangents + block);
  const auto x = reciprocal_length(dot(pi, pi)) * pi;
  const auto u = pack(q.turns[2 * angle]) * v + pack(q.turns[2 * angle + 1]) * w;
  const pack square = dot(u, u);
  double* const growth = q.growth + angle * block_lanes + lane;
  pack sum(growth, stdx::element_aligned);
  sum += 0.5 * weight * logarithm(square);
  sum.copy_to(growth, stdx::element_aligned);
  const auto unit = reciprocal_length(square) * u;
  return {half_turns(unit, cross(x, unit), x, q.degree), x[2], weight};
}

void add_direction(const frame_sums& q, int angle, int lane) {
  double* const sums = q.sums + ((lane / sum_lanes * q.angles + angle) * q.size) * sum_lanes + lane % sum_lanes;
  int node = 0;
  const auto next = [&] { return mapped(q, node++, angle, lane); };
  while (node + 4 <= q.nodes) add_functions<4>(q, {next(), next(), next(), next()}, sums);
  while (node < q.nodes) add_functions<1>(q, {next()}, sums);
}

}  // namespace
}  // namespace polhode

extern "C" POLHODE_FLATTEN void POLHODE_ENTRY(polhode_add_frames_)(const polhode::frame_sums& q) {
  for (int lane = 0; lane < q.lanes; lane += static_cast<int>(polhode::pack::size()))
    for (int angle = 0; angle < q.angles; ++angle) polhode::add_direction(q, angle, lane);
}
