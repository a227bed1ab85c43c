// SPDX-License-Identifier: Apache-2.0
#include "experiments/weak/weak_sampled.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/noise_verdict.hpp"
#include "experiments/common/path_limit.hpp"
#include "experiments/common/recorder.hpp"
#include "experiments/common/sequential.hpp"
#include "experiments/weak/common_error.hpp"
#include "experiments/weak/exact_means.hpp"
#include "experiments/weak/path_controls.hpp"
#include "experiments/weak/twin_chain.hpp"
#include "problem/vectors.hpp"

namespace polhode {
namespace {

// Paths of schemes at all levels of a grid, and of the driven equation, by one noise.

class coupled_levels {
 public:
  /// Room for so many paths. Keeps all but the context by reference as well: schemes and observables.
  coupled_levels(const context&, const std::vector<scheme_entry>&, const std::vector<observable>&, int paths);

  const level_grid& grid() const { return grid_; }
  const std::vector<direction>& directions() const { return driven_.directions; }
  const noise_log& log() const { return log_; }
  double steps_of_a_path() const;  ///< at all levels

  void run_block(int block, std::span<const int> open);

  /// Of the first paths of a scheme, f(X_dt) - f(X) path by path (values are not squares here): of each observable and,
  /// last, of all together (common_error.hpp; resolved: in standard errors).
  std::vector<squared_errors> errors(int scheme, int paths, double resolved) const;
  path_limit limit(int scheme, int paths);
  /// Of the first paths, a number a path whose mean is E[f] as the driven equation has it: of each observable.
  std::vector<squared_errors> truth(int paths) const;
  /// Of the first paths of a scheme, a number a path and level whose mean is E[f(X_dt)], whatever the driven equation.
  squared_errors values(int scheme, std::size_t observable, int paths) const;

 private:
  using level_states = std::vector<std::vector<double>>;  ///< [level], of a block
  struct sample {
    std::vector<squared_errors> differences;  ///< [observable]
    path_record paths;
  };
  struct place {
    std::size_t observable;
    int scheme, first_path, lane;
  };
  void keep(const level_states&, const driven_block& truth, const std::vector<double>& excess, place);

  const context& context_;
  const std::vector<scheme_entry>& schemes_;
  level_grid grid_;
  driven_kernels driven_;
  const std::vector<observable>& observables_;
  std::vector<std::vector<double>> squares_;  ///< f(X)^2, [observable][path]
  std::vector<squared_errors> truth_;         ///< [observable]
  path_controls controls_;
  noise_effect noise_;
  noise_log log_;
  std::vector<std::vector<std::unique_ptr<kernel>>> kernels_;  ///< [scheme][level]
  std::vector<sample> found_;
};

constexpr int coupled_cells = 8;  // of the truth in the finest step
constexpr double coupled_resolution = 64;

coupled_levels::coupled_levels(const context& c, const std::vector<scheme_entry>& schemes,
                               const std::vector<observable>& f, int paths)
    : context_(c),
      schemes_(schemes),
      grid_(asymptotic_levels(c.subject, coupled_resolution)),
      driven_(driven_kernels_of(c.subject, grid_, coupled_cells)),
      observables_(f),
      squares_(f.size(), std::vector<double>(static_cast<std::size_t>(paths))),
      truth_(f.size(), {paths, 1, std::vector<double>(static_cast<std::size_t>(paths))}),
      controls_(c.subject.model->layout(), grid_.steps.front(), grid_.horizon, paths),
      noise_{std::vector<double>(static_cast<std::size_t>(paths))},
      log_(*c.subject.model, paths / block_lanes, {{"", 0}, {"finest steps", coupled_cells}}) {
  const int levels = static_cast<int>(grid_.steps.size());
  const squared_errors room{paths, levels, std::vector<double>(static_cast<std::size_t>(paths * levels))};
  for (const auto& scheme : schemes) {
    found_.push_back({std::vector<squared_errors>(f.size(), room),
                      path_record(paths, levels, static_cast<int>(driven_.directions.size()))});
    kernels_.emplace_back();
    for (const double dt : grid_.dt()) kernels_.back().push_back(scheme.make(dt));
  }
}

double coupled_levels::steps_of_a_path() const {
  double sum = 0;
  for (const int n : grid_.steps) sum += n;
  return sum;
}

std::vector<squared_errors> coupled_levels::errors(int scheme, int paths, double resolved) const {
  auto out = found_[static_cast<std::size_t>(scheme)].differences;
  std::vector<double> sizes;
  for (auto& d : out) d.paths = paths;
  for (const auto& f : squares_) {
    double sum = 0;
    for (int p = 0; p < paths; ++p) sum += f[static_cast<std::size_t>(p)] / paths;
    sizes.push_back(std::sqrt(sum));
  }
  out = controls_.taken_out_of(out);
  out.push_back(along_their_errors(out, sizes, resolved));
  return out;
}

std::vector<squared_errors> coupled_levels::truth(int paths) const {
  auto out = truth_;
  for (auto& f : out) f.paths = paths;
  return controls_.taken_out_of(out);
}

squared_errors coupled_levels::values(int scheme, std::size_t observable, int paths) const {
  auto out = found_[static_cast<std::size_t>(scheme)].differences[observable];
  out.paths = paths;
  for (int path = 0; path < paths; ++path)
    for (int l = 0; l < out.levels; ++l) out.at(path, l) += truth_[observable].at(path, 0);
  return controls_.taken_out_of({out}).front();
}

path_limit coupled_levels::limit(int scheme, int paths) {
  auto& p = found_[static_cast<std::size_t>(scheme)].paths;
  p.error.paths = p.gap.paths = paths;
  return limit_of(context_, schemes_[static_cast<std::size_t>(scheme)].info, grid_.dt(), p, noise_, coupled_cells);
}

void coupled_levels::run_block(int block, std::span<const int> open) {
  const int first = block * block_lanes;
  driven_block truth(context_, grid_, coupled_cells, {context_.generator, noise_quality::fast}, driven_);
  const level_states start(grid_.steps.size(), replicated(context_.subject.scene.momentum));
  std::vector<level_states> states(open.size(), start);
  twin_chain chain(context_.subject, grid_, coupled_cells, driven_);
  truth.start(static_cast<std::uint64_t>(first));
  for (int chunk = 0; chunk < grid_.steps.front(); ++chunk) {
    truth.advance(chunk);
    chain.advance(truth);
    controls_.keep(first, chunk, truth.increments(0));
    log_.add(block, truth.fine(), driven_.truth->dt());
    log_.add(block, truth.increments(start.size() - 1), driven_.twins.back()->dt(), 1);
    for (std::size_t i = 0; i < open.size(); ++i)
      for (std::size_t l = 0; l < start.size(); ++l)
        kernels_[static_cast<std::size_t>(open[i])][l]->advance(states[i][l], truth.increments(l));
  }
  const auto responses = truth.responses();
  polhode::keep(responses, driven_.directions, first, noise_);
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto k = static_cast<std::size_t>(open[i]);
    polhode::keep(states[i], truth, responses, schemes_[k].needs_areas, first, found_[k].paths);
  }
  for (std::size_t f = 0; f < observables_.size(); ++f)
    for (int lane = 0; lane < block_lanes; ++lane) {
      const double end = observables_[f].value(lane_of(truth.truth(), lane, context_.subject.model->dimension()));
      squares_[f][static_cast<std::size_t>(first + lane)] = end * end;
      const auto excess = chain.excess(observables_[f].value, truth, lane);
      truth_[f].at(first + lane, 0) = end - excess.back();
      for (std::size_t i = 0; i < open.size(); ++i) keep(states[i], truth, excess, {f, open[i], first, lane});
    }
}

/// Against the driven equation that knows of the path what the scheme is told, and then its mean against the true one.
void coupled_levels::keep(const level_states& states, const driven_block& truth, const std::vector<double>& excess,
                          place at) {
  const auto scheme = static_cast<std::size_t>(at.scheme);
  const bool areas = schemes_[scheme].needs_areas;
  const auto value = [&](const std::vector<double>& all) {
    return observables_[at.observable].value(lane_of(all, at.lane, context_.subject.model->dimension()));
  };
  for (std::size_t l = 0; l < states.size(); ++l)
    found_[scheme].differences[at.observable].at(at.first_path + at.lane, static_cast<int>(l)) =
        value(states[l]) - value(areas ? truth.truth() : truth.twin(l)) + (areas ? excess.back() : excess[l]);
}

/// Of one scheme: errors and fits of the observables and, last, of all of them together.
struct scheme_finding {
  std::vector<squared_errors> errors = {};
  std::vector<std::optional<order_fit>> fits = {};
  path_limit limit = {};
};

std::vector<report::series_id> report_levels(const std::vector<observable>& observables, std::span<const double> dt,
                                             const scheme_finding& found, recorder& record) {
  std::vector<report::series_id> written;
  const auto report_one = [&](const std::string& name, std::size_t f) {
    const auto& d = found.errors[f];
    curve size{{sampled_error, name, "", "sampled"}}, variance{{"variance of the difference", name, "", "sampled"}};
    for (int l = 0; l < d.levels; ++l) {
      const auto m = level_mean(d, l);
      const double mean = std::fabs(m.mean), step = dt[static_cast<std::size_t>(l)];
      size.add(step, mean, std::max(0.0, mean - 1.96 * m.error), mean + 1.96 * m.error);
      variance.add(step, m.error * m.error * d.paths);
    }
    written.push_back(record.series(size, found.fits[f]));
    if (f == observables.size()) record.series(variance);
  };
  report_one(all_together, observables.size());
  for (std::size_t f = 0; f < observables.size(); ++f) report_one(observables[f].name, f);
  return written;
}

/// E[f(X_dt)] against the exact mean; 95 % intervals, as wide as f(X) is uncertain.
void report_against(const reference_value& exact, const std::string& name, std::span<const double> dt,
                    const squared_errors& values, recorder& record) {
  curve error{{"error against the true mean", name, "", "sampled"}};
  for (int l = 0; l < values.levels; ++l) {
    const auto m = level_mean(values, l);
    const double apart = m.mean - *exact.value, around = 1.96 * m.error + exact.uncertainty;
    error.add(dt[static_cast<std::size_t>(l)], apart, apart - around, apart + around);
  }
  record.series(error);
}

/// Of a long state fewer paths: each costs as much more.
sampling_plan plan_for(const context& c) {
  constexpr int usual = 6, first = 1024;
  const int most = by_effort(c.effort, 8192, 16384, 32768);
  return {first, std::max(first, most * usual / std::max(usual, c.subject.model->dimension()))};
}

}  // namespace

void report_sampled_orders(const context& c, const std::vector<scheme_entry>& schemes,
                           const std::vector<observable>& observables,
                           const std::function<double(const scheme_entry&)>& expected, report::results& out) {
  const auto plan = plan_for(c);
  coupled_levels levels(c, schemes, observables, blocks_of(plan.most) * block_lanes);
  const auto dt = levels.grid().dt();
  std::vector<scheme_finding> found(schemes.size());
  const auto sizes = sample_until_tight(
      c, plan, static_cast<int>(schemes.size()),
      [&](int block, std::span<const int> open) { levels.run_block(block, open); },
      [&](int scheme, int so_far) {
        auto& f = found[static_cast<std::size_t>(scheme)];
        f = {levels.errors(scheme, so_far, clear_error), {}, levels.limit(scheme, so_far)};
        const auto together = fit_order_of_clear_means(dt, f.errors.back(), clear_error, c.seed);
        return tight(f.limit) && together && half_width(*together) <= tight_order;
      });
  parallel_for(c.threads, static_cast<int>(schemes.size()), [&](int k) {
    auto& f = found[static_cast<std::size_t>(k)];
    for (const auto& d : f.errors) f.fits.push_back(fit_order_of_clear_means(dt, d, clear_error, c.seed));
  });
  const auto exact = exact_means_of(c.subject, observables, levels.grid().horizon);
  if (!exact.reason.empty()) out.skipped.push_back({"weak", "", "true means of a pair: " + exact.reason});
  // Over a scheme's own paths, and for all schemes over those that each has, so that none depends on what others need.
  const auto truth_over = [&](int paths) {
    return exact.known() ? held_to(exact, observables, levels.truth(paths)) : held_truth{};
  };
  report_truth(truth_over(plan.first), out);
  const double size = length(c.subject.scene.momentum);
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    const auto how = fmt::format("; sampled against paths of the driven equation, at time {:.4g} of {:.4g}, {}",
                                 levels.grid().horizon, c.subject.scene.horizon, sizes[k].text());
    recorder record("weak", schemes[k].info.name, out);
    const auto written = report_levels(observables, dt, found[k], record);
    if (exact.of.front().converged())
      report_against(exact.of.front(), observables.front().name, dt,
                     levels.values(static_cast<int>(k), 0, sizes[k].used), record);
    record.value({"cost", "", "path-steps", "sampled"}, at_dt(dt.back()), levels.steps_of_a_path() * sizes[k].used);
    const auto truth = truth_over(sizes[k].used);
    auto order = judge_sampled_order(expected(schemes[k]), found[k].fits.back());
    order.reason += fmt::format(" (of all {} observables together)", observables.size()) + how;
    hold_to(truth, order);
    record.verdict(weak_order_claim, std::move(order), written);
    auto limit = judge_limit(found[k].limit, levels.directions(), size);
    limit.reason += how;
    hold_to(truth, limit);
    record.verdict("limit of the law is that of the Stratonovich solution", std::move(limit));
  }
  levels.log().report("weak", out);
}

}  // namespace polhode
