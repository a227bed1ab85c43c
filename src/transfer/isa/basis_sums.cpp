// SPDX-License-Identifier: Apache-2.0
// Compiled once per instruction set: the recurrence of the harmonics in registers, the sums in the nearest cache.
#include "transfer/basis_sums.hpp"

#include <array>

#include <polhode/scalar.hpp>

#include "ensemble/kernel_of.hpp"
#include <polhode/flatten.hpp>
#include "platform/isa_entry.hpp"

namespace polhode {
namespace {

/// A state and its weight.
struct weighted_state {
  pack x, y, z;                           // of its direction
  std::array<pack, most_radial> radials;  // weight T_k(t)
};

/// weight T_k(t).
void chebyshev(const basis_sums& q, const pack& radius, double weight, std::array<pack, most_radial>& out) {
  out[0] = pack(weight);
  if (q.radial == 1) return;
  const pack t = (radius - pack(q.middle)) * pack(1 / q.half), edge(most_outside);
  const pack inside = select(t > edge, edge, select(t < -edge, pack(-edge), t));
  out[1] = weight * inside;
  for (int k = 2; k < q.radial; ++k) {
    const auto i = static_cast<std::size_t>(k);
    out[i] = 2 * inside * out[i - 1] - out[i - 2];
  }
}

void load(const basis_sums& q, const double* at, double weight, weighted_state& out) {
  const auto pi = load_lanes<pack, 3>(at);
  const pack radius = square_root(pack(pi[0] * pi[0] + pi[1] * pi[1] + pi[2] * pi[2])), scale = pack(1.0) / radius;
  out.x = scale * pi[0];
  out.y = scale * pi[1];
  out.z = scale * pi[2];
  chebyshev(q, radius, weight, out.radials);
}

/// Harmonics factor p, p on a sphere with the weight in it.
template <bool on_a_sphere, std::size_t count>
void add_rows(double* at, int radial, const std::array<pack, count>& factor, const std::array<pack, count>& p,
              const std::array<weighted_state, count>& states) {
  if constexpr (on_a_sphere) {
    pack sum(at, stdx::element_aligned);
    for (std::size_t i = 0; i < count; ++i) sum += factor[i] * p[i];
    sum.copy_to(at, stdx::element_aligned);
    return;
  }
  std::array<pack, count> harmonics;
  for (std::size_t i = 0; i < count; ++i) harmonics[i] = factor[i] * p[i];
  for (int k = 0; k < radial; ++k) {
    pack sum(at + k * sum_lanes, stdx::element_aligned);
    for (std::size_t i = 0; i < count; ++i) sum += harmonics[i] * states[i].radials[static_cast<std::size_t>(k)];
    sum.copy_to(at + k * sum_lanes, stdx::element_aligned);
  }
}

/// Of several states at a time: their recurrences hide each other's latency, and the sums are touched once.
template <bool on_a_sphere, std::size_t count>
void add_states(const basis_sums& q, const double* first, const double* weights, double* sums) {
  std::array<weighted_state, count> states;
  std::array<pack, count> cosine, sine, p, before;
  for (std::size_t i = 0; i < count; ++i) {
    load(q, first + i * 3 * block_lanes, weights[i], states[i]);
    cosine[i] = pack(1.0);
    sine[i] = pack(0.0);
  }
  const int row = q.radial * sum_lanes;
  const double* factor = q.recurrence;
  for (int m = 0; m <= q.degree; ++m) {
    const double highest = *factor++;
    for (std::size_t i = 0; i < count; ++i) {
      const pack turned = cosine[i] * states[i].x - sine[i] * states[i].y;
      if (m > 0) {
        sine[i] = cosine[i] * states[i].y + sine[i] * states[i].x;
        cosine[i] = turned;
      }
      before[i] = pack(0.0);
      p[i] = pack(on_a_sphere ? highest * weights[i] : highest);
    }
    for (int l = m; l <= q.degree; ++l, factor += 2) {
      double* const middle = sums + (l * l + l) * row;
      add_rows<on_a_sphere>(middle + m * row, q.radial, cosine, p, states);
      if (m > 0) add_rows<on_a_sphere>(middle - m * row, q.radial, sine, p, states);
      for (std::size_t i = 0; i < count; ++i) {
        const pack next = factor[0] * states[i].z * p[i] - factor[1] * before[i];
        before[i] = p[i];
        p[i] = next;
      }
    }
  }
}

template <bool on_a_sphere>
void add_all(const basis_sums& q) {
  constexpr int together = 4;
  const int group = (q.degree + 1) * (q.degree + 1) * q.radial * sum_lanes;
  for (int lane = 0; lane < q.lanes; lane += static_cast<int>(pack::size())) {
    const double* const states = q.states + lane;
    double* const sums = q.sums + lane / sum_lanes * group + lane % sum_lanes;
    int i = 0;
    for (; i + together <= q.nodes; i += together)
      add_states<on_a_sphere, together>(q, states + i * 3 * block_lanes, q.weights + i, sums);
    for (; i < q.nodes; ++i) add_states<on_a_sphere, 1>(q, states + i * 3 * block_lanes, q.weights + i, sums);
  }
}

}  // namespace
}  // namespace polhode

extern "C" POLHODE_FLATTEN void POLHODE_ENTRY(polhode_add_basis_)(const polhode::basis_sums& q) {
  if (q.radial == 1)
    polhode::add_all<true>(q);
  else
    polhode::add_all<false>(q);
}
