// SPDX-License-Identifier: Apache-2.0
// How far is a path from the true path, and how fast does that fall with dt?
//
// All levels are driven by one piecewise linear path on a fine grid; the reference solves the Wong-Zakai equation of
// that path (references/wong_zakai_equation.hpp), and a coarse step is given that path's increment and Levy areas by
// Chen's relation. So nothing is redrawn between levels, and the reference is none of the schemes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/common/driven_block.hpp"
#include "experiments/common/experiment.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/noise_verdict.hpp"
#include "experiments/common/path_limit.hpp"
#include "experiments/common/recorder.hpp"
#include "experiments/common/sequential.hpp"
#include "experiments/strong/path_orders.hpp"
#include "experiments/strong/strong_order.hpp"
#include "problem/vectors.hpp"
#include "references/wong_zakai_equation.hpp"
#include "statistics/orders/order_fit.hpp"

namespace polhode {
namespace {

// How far is the reference itself from the solution?
//
// Experiment strong compares with Y_d, the solution driven by the piecewise linear path of cells of width d, which
// tends to the Stratonovich solution X: Wong, Zakai, Ann. Math. Stat. 36 (1965) 1560-1564. Its order g in mean square
// is 1/2, as of all that know no areas inside a cell (Clark, Cameron, Lect. Notes Control Inf. Sci. 25 (1980) 162-171),
// and 1 where the noise commutes. The twins (driven_block.hpp) are Y at the steps of the levels, so that
// D_d = |Y_d - Y_{d/2}| is measured there and D_d ~ a d^g extrapolated to the reference's own cells:
//
//   |Y_d - X| <= sum_k D_{d / 2^k} = D_d / (1 - 2^-g)

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

/// dt: steps of the levels but the finest; order: g; cell: width of the reference's cells.
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

/// Kernels of every scheme at every level.
using kernel_table = std::vector<std::vector<std::unique_ptr<kernel>>>;

/// Everything that the blocks of a run share.
struct strong_run {
  const context& c;
  level_grid grid;
  kernel_table kernels;
  driven_kernels driven;
  std::vector<path_record> records;     ///< [scheme]
  std::vector<largest_errors> largest;  ///< [scheme]
  noise_effect noise;
  halved_references halved;
  noise_log& log;
};

/// Runs one block of paths of the open schemes and keeps their errors.
void run_block(strong_run& r, std::span<const int> open, int block) {
  const auto& s = r.c.subject;
  const std::size_t levels = r.grid.steps.size();
  driven_block truth(r.c, r.grid, fine_per_step, {r.c.generator, noise_quality::precise}, r.driven,
                     looks_in_coarsest(r.grid));
  std::vector<std::vector<std::vector<double>>> states(
      r.kernels.size(), std::vector<std::vector<double>>(levels, replicated(s.scene.momentum)));
  const int first_path = block * block_lanes;
  const std::vector<std::size_t> indices(open.begin(), open.end());
  truth.start(static_cast<std::uint64_t>(first_path));
  for (int chunk = 0; chunk < r.grid.steps.front(); ++chunk) {
    truth.advance(chunk);
    r.log.add(block, truth.fine(), r.driven.truth->dt());
    r.log.add(block, truth.increments(levels - 1), r.driven.twins.back()->dt(), 1);
    for (const auto k : indices)
      for (std::size_t l = 0; l < levels; ++l)
        r.largest[k].advance(*r.kernels[k][l], truth, l, first_path, states[k][l]);
  }
  const auto responses = truth.responses();
  keep(responses, r.driven.directions, first_path, r.noise);
  r.halved.keep(truth, first_path);
  for (const auto k : indices) keep(states[k], truth, responses, s.schemes[k].needs_areas, first_path, r.records[k]);
}

void report_scheme(const strong_run& r, std::size_t k, const strong_finding& found, recorder& record) {
  const auto dt = r.grid.dt();
  const strong_question q{r.c, r.c.subject.schemes[k], dt};
  const auto& errors = r.records[k].error;
  report_order(q, errors, found, record);
  report_path_orders({r.c, q.claimed(), found.leading.low > 0, dt, r.grid}, errors, r.largest[k].squares, record);
  report_limit(q, r.driven.directions, found, record);
}

/// On the paths that every run has, whichever its schemes.
void report_the_reference(strong_run& r, int paths, report::results& out) {
  const auto all = r.grid.dt();
  const auto coarser = std::span(all).first(all.size() - 1);
  const double order = strong_order_on(wong_zakai_equation::info, r.c.subject.model->noise()),
               cell = all.back() / fine_per_step;
  r.halved.squares.paths = paths;
  const auto found = distance_of_reference(coarser, r.halved, order, cell, r.c.seed);
  recorder record("strong", "", out);
  report_reference(found, coarser, r.halved, order, cell, length(r.c.subject.scene.momentum), record);
}

/// Room for so many paths.
strong_run prepared(const context& c, int paths, noise_log& log) {
  const auto& s = c.subject;
  const auto grid = asymptotic_levels(s, by_effort(c.effort, 256.0, 256.0, 512.0));
  const auto dt = grid.dt();
  const auto levels = static_cast<int>(dt.size());
  strong_run r{c,
               grid,
               kernel_table(s.schemes.size()),
               driven_kernels_of(s, grid, fine_per_step),
               {},
               {},
               {std::vector<double>(static_cast<std::size_t>(paths))},
               halved_references(paths, levels),
               log};
  r.records.assign(s.schemes.size(), path_record(paths, levels, static_cast<int>(r.driven.directions.size())));
  r.largest.assign(s.schemes.size(), largest_errors(paths, levels));
  for (std::size_t k = 0; k < s.schemes.size(); ++k)
    for (const double h : dt) r.kernels[k].push_back(s.schemes[k].make(h));
  return r;
}

void run(const context& c, report::results& out) {
  const auto& s = c.subject;
  const sampling_plan plan{320, by_effort(c.effort, 640, 2048, 8192)};
  noise_log log(*s.model, blocks_of(plan.most), {{"", 0}, {"finest steps", fine_per_step}});
  auto r = prepared(c, blocks_of(plan.most) * block_lanes, log);
  const auto dt = r.grid.dt();
  std::vector<strong_finding> found(s.schemes.size());
  const auto sizes = sample_until_tight(
      c, plan, static_cast<int>(s.schemes.size()),
      [&](int block, std::span<const int> open) { run_block(r, open, block); },
      [&](int scheme, int so_far) {
        const auto k = static_cast<std::size_t>(scheme);
        r.records[k].error.paths = r.records[k].gap.paths = r.largest[k].squares.paths = so_far;
        const strong_question q{c, s.schemes[k], dt};
        found[k] = find_order(q, r.records[k], r.noise);
        return tight(q, r.records[k].error, found[k]);
      });
  for (std::size_t k = 0; k < s.schemes.size(); ++k) {
    recorder record("strong", s.schemes[k].info.name, out);
    report_scheme(r, k, found[k], record);
    record.remark(sizes[k].text());
  }
  log.report("strong", out);
  report_the_reference(r, blocks_of(plan.first) * block_lanes, out);
}

expected_work work_of(const subject& s, effort e) { return {by_effort(e, 3e6, 4e6, 1e7), s.sphere() ? 0.05 : 0}; }

}  // namespace

experiment strong_experiment() {
  return {
      {"strong",
       "How far is a path from the true path driven by the same noise, and how fast does that fall with dt?",
       {"Distance at the end of the horizon (at most four of the fastest time scales): root mean square, L^1 and L^4; "
        "and root mean square of the largest at the ends of a level's own steps, of the finest level of every second "
        "step, and of all levels of a fit at those of its coarsest where these are fewer than 32 (a maximum over few "
        "times misses more of the supremum: with 32 and more slopes come out 0.01 to 0.02 too flat). Where an order "
        "holds in every L^p, almost every path has it, but for any eps > 0 (Kloeden, Neuenkirch 2007); the median of "
        "the slopes of single paths is held against the claim as well. A steeper slope than claimed refutes the root "
        "mean square alone.",
        fmt::format(
            "The driver is piecewise linear, with {} cells in the finest step; the reference solves the ordinary "
            "differential equation driven by it, and coarse steps get its exact increments and Levy areas.",
            fine_per_step),
        "Limit: what is left of the distance as dt -> 0, and the strengths at which noise, dissipation and time are "
        "felt there (projections on the derivatives of the true end point), each against one. A scheme without "
        "Levy areas is compared with the driven equation on its own increments, which has the same limit.",
        "Where more than order 1/2 is claimed: the strength at which Levy areas are felt, 0 by a scheme without them. "
        "The wrong strength leaves a term of order 1/2, however small beside the scheme's own error.",
        "Noise: the moments and correlations of all that was drawn, against their law.",
        "Reference: what is converged to is the Wong-Zakai solution, which differs from the Stratonovich solution by "
        "the areas inside the fine cells. That moves no slope while dt is well above a cell. How far it is: from "
        "references of the levels' own steps as cells, extrapolated (row noise).",
        "Normals: precise ones."}},
      work_of,
      [](const subject& s) -> std::optional<std::string> {
        if (s.model->noise() == noise_class::none)
          return "no noise: the experiment energy measures the order for sigma = 0";
        return std::nullopt;
      },
      run};
}

}  // namespace polhode
