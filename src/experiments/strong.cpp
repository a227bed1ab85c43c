// How far is a path from the true path, and how fast does that fall with dt?
//
// All levels are driven by one piecewise linear path on a fine grid; the reference is the ordinary differential
// equation driven by that path (references/driven_ode.hpp), and a coarse step is given that path's increment and Levy
// areas by Chen's relation. So nothing is redrawn between levels, and the reference is none of the schemes.
#include <fmt/format.h>

#include <cmath>

#include "experiments/experiment.hpp"
#include "experiments/increment_ladder.hpp"
#include "experiments/judge.hpp"
#include "experiments/levels.hpp"
#include "experiments/sequential.hpp"
#include "experiments/vectors.hpp"
#include "statistics/order_fit.hpp"

namespace polhode {
namespace {

constexpr int fine_per_step = 32;      // fine cells in the finest step
constexpr double limit_bound = 0.1;    // of the distance to the Ito solution: how near the limit dt -> 0 must be
constexpr double tight_leading = 0.1;  // of the mean square error: half-width of its part of the claimed order

/// Kernels of every scheme at every level.
using kernel_table = std::vector<std::vector<std::unique_ptr<kernel>>>;

/// Runs one block of paths of the open schemes and writes its squared errors.
void run_block(const context& c, const level_grid& grid, const kernel_table& kernels, const kernel& reference,
               std::span<const int> open, int block, std::vector<squared_errors>& errors) {
  const auto& s = c.subject;
  const std::size_t levels = grid.steps.size();
  increment_ladder ladder(*s.model, grid, fine_per_step, {c.generator, noise_quality::precise});
  auto truth = replicated(s.scene.momentum);
  std::vector<std::vector<std::vector<double>>> states(kernels.size(), std::vector<std::vector<double>>(levels, truth));
  const int first_path = block * block_lanes;
  const std::vector<std::size_t> indices(open.begin(), open.end());
  for (int chunk = 0; chunk < grid.steps.front(); ++chunk) {
    reference.advance(truth, ladder.fill(c.seed, static_cast<std::uint64_t>(first_path), chunk));
    for (const auto k : indices)
      for (std::size_t l = 0; l < levels; ++l) kernels[k][l]->advance(states[k][l], ladder.level(l));
  }
  for (const auto k : indices)
    for (std::size_t l = 0; l < levels; ++l)
      for (int lane = 0; lane < block_lanes; ++lane) {
        double square = 0;
        for (std::size_t i = static_cast<std::size_t>(lane); i < truth.size(); i += block_lanes)
          square += std::pow(states[k][l][i] - truth[i], 2);
        errors[k].at(first_path + lane, static_cast<int>(l)) = square;
      }
}

/// About how far the solution of the Ito equation is from that of the Stratonovich equation after a time t, in |mu_0|.
double ito_distance(const report::scene& scene, double t) {
  double sigma2 = 0;
  for (const auto& v : scene.sigma) sigma2 += (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / 3;
  return std::min(1.0, sigma2 * t);
}

/// A slope above the claim: weak noise can hide the term of the claimed order under a larger one of higher order. If
/// that term is there the claim is right, and only the range of dt is kind; if it cannot be seen, nothing is decided.
void judge_hidden_order(const interval_estimate& leading, double claimed, const order_fit& fit, report::verdict& v) {
  const bool seen = leading.low > 0;
  v.kind = seen ? report::verdict_kind::holds : report::verdict_kind::inconclusive;
  v.reason = fmt::format(
      "order {:.3f} [{:.3f}, {:.3f}] at these dt, above the claimed {:g}: the noise is weak. Mean square error "
      "~ {:.2e} [{:.2e}, {:.2e}] dt^{:g} + …: the term of the claimed order is {}",
      fit.order, fit.low, fit.high, claimed, leading.value, leading.low, leading.high, 2 * claimed,
      seen ? "there" : "not seen");
}

/// What is found for one scheme at the end of a batch.
struct finding {
  std::optional<order_fit> fit;
  error_model error;
};

finding find(const context& c, const scheme_entry& scheme, std::span<const double> dt, const squared_errors& errors) {
  const double claimed = strong_order_on(scheme.info, c.subject.model->noise());
  finding f{fit_order(dt, errors, 1e-13 * length(c.subject.scene.momentum), c.seed), {}};
  if (!f.fit) return f;
  // What hides the term of the claimed order is its cross term with the next and the square of that.
  const int powers = f.fit->order > claimed + order_margin ? 3 : 2;
  f.error = fit_error_model(dt, errors, f.fit->used, claimed, c.seed, powers);
  return f;
}

/// How near the limit dt -> 0 must be to the Stratonovich solution.
double bound_of_limit(const context& c, double horizon) {
  return limit_bound * length(c.subject.scene.momentum) * ito_distance(c.subject.scene, horizon);
}

/// By widths alone: of the order, of the limit's distance, and of the leading coefficient, whose unit is the whole mean
/// square error at the finest dt. Without a fit more paths would not help.
bool tight(const context& c, const scheme_entry& scheme, const level_grid& grid, const squared_errors& errors,
           const finding& f) {
  if (!f.fit) return true;
  const double claimed = strong_order_on(scheme.info, c.subject.model->noise());
  const double unit = level_mean(errors, errors.levels - 1).mean / std::pow(grid.dt().back(), 2 * claimed);
  return half_width(*f.fit) <= tight_order && half_width(f.error.limit) <= bound_of_limit(c, grid.horizon) / 3 &&
         half_width(f.error.leading) <= tight_leading * unit;
}

void report_scheme(const context& c, const scheme_entry& scheme, const level_grid& grid, const squared_errors& errors,
                   const finding& found, report::results& out) {
  const auto dt = grid.dt();
  const double size = length(c.subject.scene.momentum);
  const series s{"strong", std::string(scheme.info.name), "error", "state", "|mu|", "sampled"};
  const auto& [fit, error] = found;
  std::vector<report::measurement> points;
  for (int l = 0; l < errors.levels; ++l) {
    const auto m = level_mean(errors, l);
    const auto root = [](double x) { return std::sqrt(std::max(0.0, x)); };
    points.push_back(measured(s, dt[static_cast<std::size_t>(l)], root(m.mean), root(m.mean - 1.96 * m.error),
                              root(m.mean + 1.96 * m.error)));
  }
  record_fit(out, s, fit, std::move(points));
  const double claimed = strong_order_on(scheme.info, c.subject.model->noise());
  auto order = judge_order({s.experiment, s.scheme, "strong order"}, claimed, fit, false);
  const claim limit{s.experiment, s.scheme, "limit is the Stratonovich solution"};
  if (!fit) {
    out.verdicts.push_back(order);
    out.verdicts.push_back(judge_distance(limit, {NAN, NAN, NAN}, 0, "no usable levels"));
    return;
  }
  if (fit->high > claimed + order_margin && fit->low >= claimed - order_margin)
    judge_hidden_order(error.leading, claimed, *fit, order);
  out.verdicts.push_back(order);
  const double bound = bound_of_limit(c, grid.horizon) / size;
  const interval_estimate relative{error.limit.value / size, error.limit.low / size, error.limit.high / size};
  out.verdicts.push_back(judge_distance(
      limit, relative, bound,
      fmt::format("distance from the solution as dt -> 0, in units of |mu_0|: at most {:.2g}, bound {:.2g}",
                  relative.high, bound)));
}

void run(const context& c, report::results& out) {
  const auto& s = c.subject;
  const auto grid = asymptotic_levels(s, by_effort(c.effort, 256.0, 256.0, 512.0));
  const auto dt = grid.dt();
  const sampling_plan plan{320, by_effort(c.effort, 640, 2048, 8192)};
  const int paths = blocks_of(plan.most) * block_lanes, levels = static_cast<int>(grid.steps.size());
  kernel_table kernels(s.schemes.size());
  std::vector<squared_errors> errors(s.schemes.size(),
                                     {paths, levels, std::vector<double>(static_cast<std::size_t>(paths * levels))});
  for (std::size_t k = 0; k < s.schemes.size(); ++k)
    for (const double h : dt) kernels[k].push_back(s.schemes[k].make(h));
  const auto reference = s.model->reference();
  std::vector<finding> found(s.schemes.size());
  const auto sizes = sample_until_tight(
      c, plan, static_cast<int>(s.schemes.size()),
      [&](int block, std::span<const int> open) { run_block(c, grid, kernels, *reference, open, block, errors); },
      [&](int scheme, int so_far) {
        const auto k = static_cast<std::size_t>(scheme);
        errors[k].paths = so_far;
        found[k] = find(c, s.schemes[k], dt, errors[k]);
        return tight(c, s.schemes[k], grid, errors[k], found[k]);
      });
  for (std::size_t k = 0; k < s.schemes.size(); ++k) {
    report_scheme(c, s.schemes[k], grid, errors[k], found[k], out);
    note_sample_size(out, "strong", s.schemes[k].info.name, sizes[k]);
  }
}

}  // namespace

experiment strong_experiment() {
  return {{"strong",
           "How far is a path from the true path driven by the same noise, and how fast does that fall with dt?",
           {"Root-mean-square distance at the end of the horizon (at most four of the fastest time scales).",
            fmt::format(
                "The driver is piecewise linear, with {} cells in the finest step; the reference solves the ordinary "
                "differential equation driven by it, and coarse steps get its exact increments and Levy areas.",
                fine_per_step),
            "Normals: precise ones. The driver differs from Brownian motion by the areas inside the fine cells, which "
            "moves no slope while dt is "
            "well above a cell."}},
          3,
          [](const subject& s) -> std::optional<std::string> {
            if (s.model->noise() == noise_class::none)
              return "no noise: the experiment energy measures the order for sigma = 0";
            return std::nullopt;
          },
          run};
}

}  // namespace polhode
