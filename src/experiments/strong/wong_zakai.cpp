// SPDX-License-Identifier: Apache-2.0
#include "experiments/strong/wong_zakai.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/common/judge.hpp"
#include "experiments/common/noise_verdict.hpp"

namespace polhode {

void halved_references::keep(const driven_block& at_the_end, int first_path) {
  std::array<double, block_lanes> square{};
  for (int l = 0; l < squares.levels; ++l) {
    const auto at = static_cast<std::size_t>(l);
    const auto &coarse = at_the_end.twin(at), &fine = at_the_end.twin(at + 1);
    square.fill(0);
    for (std::size_t i = 0; i < coarse.size(); ++i) square[i % block_lanes] += std::pow(coarse[i] - fine[i], 2);
    for (int lane = 0; lane < block_lanes; ++lane)
      squares.at(first_path + lane, l) = square[static_cast<std::size_t>(lane)];
  }
}

reference_distance distance_of_reference(std::span<const double> dt, const halved_references& r, double order,
                                         double cell, std::uint64_t seed) {
  reference_distance out{fit_order(dt, r.squares, 0, seed), {NAN, NAN, NAN}, {NAN, NAN, NAN}};
  if (!out.decay) return out;
  const auto square = fit_error_model(dt, r.squares, out.decay->used, order, seed).leading;
  const auto at_cell = [&](double a) { return std::sqrt(std::max(0.0, a)) * std::pow(cell, order); };
  out.halved = {at_cell(square.value), at_cell(square.low), at_cell(square.high)};
  const double sum = 1 / (1 - std::exp2(-order));
  out.bound = {sum * out.halved.value, sum * out.halved.low, sum * out.halved.high};
  return out;
}

void report_reference(const reference_distance& d, std::span<const double> dt, const halved_references& r, double order,
                      double cell, double size, recorder& record) {
  curve apart{{"distance between references", "state", "|mu|", "sampled"}, "width of a cell"};
  for (int l = 0; l < r.squares.levels; ++l) {
    const auto m = level_norm(r.squares, 2, l);
    apart.add(dt[static_cast<std::size_t>(l)], m.mean, std::max(0.0, m.mean - 1.96 * m.error), m.mean + 1.96 * m.error);
  }
  const auto decay = record.series(apart, d.decay);
  const auto bound = record.value({"distance of the reference", "", apart.what.unit, apart.what.method}, d.bound);
  auto v = judge_order(order, d.decay, true);
  if (d.decay && d.decay->low >= order - order_margin) v.kind = report::verdict_kind::holds;  // steeper is nearer
  v.reason += fmt::format(
      "; the reference is the Wong-Zakai solution of cells of {:.2e}, D = |Y_cell - Y_cell/2| = {:.1e} [{:.1e}, "
      "{:.1e}] of |mu_0| there, from the solution at most {:.1e} [{:.1e}, {:.1e}]",
      cell, d.halved.value / size, d.halved.low / size, d.halved.high / size, d.bound.value / size, d.bound.low / size,
      d.bound.high / size);
  record.of(noise_name).verdict("reference tends to the Stratonovich solution", v, {decay, bound});
}

}  // namespace polhode
