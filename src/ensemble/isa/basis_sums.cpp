// Compiled once per instruction set: the recurrence of the harmonics in registers, the sums in the nearest cache.
#include "ensemble/basis_sums.hpp"

#include <array>

#include <polhode/scalar.hpp>

#include "ensemble/flatten.hpp"
#include "ensemble/isa_entry.hpp"
#include "ensemble/kernel_of.hpp"

namespace polhode {
namespace {

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

void add_to(double* at, const pack& value) {
  pack sum;
  sum.copy_from(at, stdx::element_aligned);
  sum += value;
  sum.copy_to(at, stdx::element_aligned);
}

template <bool on_a_sphere>
void add_row(double* at, int radial, const pack& harmonic, const std::array<pack, most_radial>& radials) {
  if constexpr (on_a_sphere)
    add_to(at, harmonic * radials[0]);
  else
    for (int k = 0; k < radial; ++k) add_to(at + k * sum_lanes, harmonic * radials[static_cast<std::size_t>(k)]);
}

template <bool on_a_sphere>
void add_state(const basis_sums& q, const double* state, double weight, double* sums) {
  const auto pi = load_lanes<pack, 3>(state);
  const pack radius = square_root(pack(pi[0] * pi[0] + pi[1] * pi[1] + pi[2] * pi[2])), scale = pack(1.0) / radius;
  const pack x = scale * pi[0], y = scale * pi[1], z = scale * pi[2];
  std::array<pack, most_radial> radials;
  chebyshev(q, radius, weight, radials);
  const int row = q.radial * sum_lanes;
  const double* factor = q.recurrence;
  pack cosine(1.0), sine(0.0);
  for (int m = 0; m <= q.degree; ++m) {
    if (m > 0) {
      const pack turned = cosine * x - sine * y;
      sine = cosine * y + sine * x;
      cosine = turned;
    }
    pack before(0.0), p(*factor++);
    for (int l = m; l <= q.degree; ++l, factor += 2) {
      double* const middle = sums + (l * l + l) * row;
      add_row<on_a_sphere>(middle + m * row, q.radial, cosine * p, radials);
      if (m > 0) add_row<on_a_sphere>(middle - m * row, q.radial, sine * p, radials);
      const pack next = factor[0] * z * p - factor[1] * before;
      before = p;
      p = next;
    }
  }
}

template <bool on_a_sphere>
void add_all(const basis_sums& q) {
  const int group = (q.degree + 1) * (q.degree + 1) * q.radial * sum_lanes;
  for (int lane = 0; lane < q.lanes; lane += static_cast<int>(pack::size()))
    for (int i = 0; i < q.nodes; ++i)
      add_state<on_a_sphere>(q, q.states + i * 3 * block_lanes + lane, q.weights[i],
                             q.sums + lane / sum_lanes * group + lane % sum_lanes);
}

}  // namespace
}  // namespace polhode

extern "C" POLHODE_FLATTEN void POLHODE_ENTRY(polhode_add_basis_)(const polhode::basis_sums& q) {
  if (q.radial == 1)
    polhode::add_all<true>(q);
  else
    polhode::add_all<false>(q);
}
