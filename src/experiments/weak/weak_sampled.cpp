#include "experiments/weak/weak_sampled.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/common/noise_verdict.hpp"
#include "experiments/common/path_limit.hpp"
#include "experiments/common/recorder.hpp"
#include "experiments/common/sequential.hpp"
#include "experiments/weak/common_error.hpp"
#include "experiments/weak/path_controls.hpp"
#include "experiments/weak/twin_chain.hpp"
#include "problem/vectors.hpp"

namespace polhode {
namespace {

constexpr int cells = 8;        // of the truth in the finest step
constexpr double resolved = 5;  // standard errors
constexpr double resolution = 64;

/// Of one scheme: f(X_dt) - f(X), path by path, and its distance from the path X.
struct sample {
  std::vector<squared_errors> differences;  ///< [observable], values are not squares here
  path_record paths;
};

class coupled_levels {
 public:
  coupled_levels(const context& c, const std::vector<scheme_entry>& schemes, const std::vector<observable>& f,
                 int paths)
      : context_(c),
        schemes_(schemes),
        grid_(asymptotic_levels(c.subject, resolution)),
        driven_(driven_kernels_of(c.subject, grid_, cells)),
        observables_(f),
        squares_(f.size(), std::vector<double>(static_cast<std::size_t>(paths))),
        controls_(c.subject.model->layout(), grid_.steps.front(), grid_.horizon, paths),
        noise_{std::vector<double>(static_cast<std::size_t>(paths))},
        log_(*c.subject.model, paths / block_lanes, {{"", 0}, {"finest steps", cells}}) {
    const int levels = static_cast<int>(grid_.steps.size());
    const squared_errors room{paths, levels, std::vector<double>(static_cast<std::size_t>(paths * levels))};
    for (const auto& scheme : schemes) {
      found_.push_back({std::vector<squared_errors>(f.size(), room),
                        path_record(paths, levels, static_cast<int>(driven_.directions.size()))});
      kernels_.emplace_back();
      for (const double dt : grid_.dt()) kernels_.back().push_back(scheme.make(dt));
    }
  }

  const level_grid& grid() const { return grid_; }
  const std::vector<direction>& directions() const { return driven_.directions; }
  const noise_log& log() const { return log_; }
  double path_steps() const {
    double sum = 0;
    for (const int n : grid_.steps) sum += n;
    return sum;
  }
  sample& of(int scheme) { return found_[static_cast<std::size_t>(scheme)]; }

  /// Of the first paths: the differences of each observable and, last, of all together.
  std::vector<squared_errors> errors(int scheme, int so_far) {
    auto out = of(scheme).differences;
    std::vector<double> sizes;
    for (auto& d : out) d.paths = so_far;
    for (const auto& f : squares_) {
      double sum = 0;
      for (int p = 0; p < so_far; ++p) sum += f[static_cast<std::size_t>(p)] / so_far;
      sizes.push_back(std::sqrt(sum));
    }
    out = controls_.taken_out_of(out);
    out.push_back(along_their_errors(out, sizes, resolved));
    return out;
  }

  path_limit limit(int scheme, int so_far) {
    auto& p = of(scheme).paths;
    p.error.paths = p.gap.paths = so_far;
    return limit_of(context_, schemes_[static_cast<std::size_t>(scheme)].info, grid_.dt(), p, noise_, cells);
  }

  void run_block(int block, std::span<const int> open) {
    const int first = block * block_lanes;
    driven_block truth(context_, grid_, cells, {context_.generator, noise_quality::fast}, driven_);
    const std::vector<std::vector<double>> start(grid_.steps.size(), replicated(context_.subject.scene.momentum));
    std::vector<std::vector<std::vector<double>>> states(open.size(), start);
    twin_chain chain(context_.subject, grid_, cells, driven_);
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
    for (std::size_t i = 0; i < open.size(); ++i)
      polhode::keep(states[i], truth, responses, schemes_[static_cast<std::size_t>(open[i])].needs_areas, first,
                    of(open[i]).paths);
    for (std::size_t f = 0; f < observables_.size(); ++f)
      for (int lane = 0; lane < block_lanes; ++lane) {
        const double end = observables_[f].value(lane_of(truth.truth(), lane, context_.subject.model->dimension()));
        squares_[f][static_cast<std::size_t>(first + lane)] = end * end;
        const auto excess = chain.excess(observables_[f].value, truth, lane);
        for (std::size_t i = 0; i < open.size(); ++i) keep(states[i], truth, excess, {f, open[i], first, lane});
      }
  }

 private:
  struct place {
    std::size_t observable;
    int scheme, first_path, lane;
  };
  /// Against the driven equation that knows of the path what the scheme is told, and then its mean against the true
  /// one.
  void keep(const std::vector<std::vector<double>>& states, const driven_block& truth,
            const std::vector<double>& excess, place at) {
    const bool areas = schemes_[static_cast<std::size_t>(at.scheme)].needs_areas;
    const auto value = [&](const std::vector<double>& all) {
      return observables_[at.observable].value(lane_of(all, at.lane, context_.subject.model->dimension()));
    };
    for (std::size_t l = 0; l < states.size(); ++l)
      of(at.scheme).differences[at.observable].at(at.first_path + at.lane, static_cast<int>(l)) =
          value(states[l]) - value(areas ? truth.truth() : truth.twin(l)) + (areas ? excess.back() : excess[l]);
  }

  const context& context_;
  const std::vector<scheme_entry>& schemes_;
  level_grid grid_;
  driven_kernels driven_;
  const std::vector<observable>& observables_;
  std::vector<std::vector<double>> squares_;  ///< f(X)^2, [observable][path]
  path_controls controls_;
  noise_effect noise_;
  noise_log log_;
  std::vector<std::vector<std::unique_ptr<kernel>>> kernels_;  // [scheme][level]
  std::vector<sample> found_;
};

/// Of one scheme: errors and fits of the observables and, last, of all of them together.
struct scheme_finding {
  std::vector<squared_errors> errors = {};
  std::vector<std::optional<order_fit>> fits = {};
  path_limit limit = {};
};

std::vector<report::series_id> report_levels(const std::vector<observable>& observables, std::span<const double> dt,
                                             const scheme_finding& found, recorder& record) {
  std::vector<report::series_id> written;
  for (std::size_t f = 0; f < found.errors.size(); ++f) {
    const auto& d = found.errors[f];
    const auto name = f < observables.size() ? observables[f].name : "all, in their sizes";
    curve size{{"difference", name, "", "sampled"}}, variance{{"variance of the difference", name, "", "sampled"}};
    for (int l = 0; l < d.levels; ++l) {
      const auto m = level_mean(d, l);
      const double mean = std::fabs(m.mean), step = dt[static_cast<std::size_t>(l)];
      size.add(step, mean, std::max(0.0, mean - 1.96 * m.error), mean + 1.96 * m.error);
      variance.add(step, m.error * m.error * d.paths);
    }
    record.series(variance);
    written.push_back(record.series(size, found.fits[f]));
  }
  return written;
}

report::verdict judge_slope(double expected, const std::optional<order_fit>& fit) {
  if (!fit)
    return {.expected = expected, .reason = "fewer than four levels whose error is clear of the sampling error"};
  if (half_width(*fit) <= order_margin) return judge_order(expected, fit, true);
  return {.expected = expected,
          .estimate = fit->order,
          .low = fit->low,
          .high = fit->high,
          .reason = fmt::format("order {:.3f} [{:.3f}, {:.3f}]: wider than the margin of {:g}", fit->order, fit->low,
                                fit->high, order_margin)};
}

}  // namespace

void report_sampled_orders(const context& c, const std::vector<scheme_entry>& schemes,
                           const std::vector<observable>& observables,
                           const std::function<double(const scheme_entry&)>& expected, report::results& out) {
  const sampling_plan plan{1024, by_effort(c.effort, 8192, 16384, 32768)};
  coupled_levels levels(c, schemes, observables, blocks_of(plan.most) * block_lanes);
  const auto dt = levels.grid().dt();
  std::vector<scheme_finding> found(schemes.size());
  const auto sizes = sample_until_tight(
      c, plan, static_cast<int>(schemes.size()),
      [&](int block, std::span<const int> open) { levels.run_block(block, open); },
      [&](int scheme, int so_far) {
        auto& f = found[static_cast<std::size_t>(scheme)];
        f = {levels.errors(scheme, so_far), {}, levels.limit(scheme, so_far)};
        const auto together = fit_order_of_clear_means(dt, f.errors.back(), resolved, c.seed);
        return tight(f.limit) && together && half_width(*together) <= tight_order;
      });
  parallel_for(c.threads, static_cast<int>(schemes.size()), [&](int k) {
    auto& f = found[static_cast<std::size_t>(k)];
    for (const auto& d : f.errors) f.fits.push_back(fit_order_of_clear_means(dt, d, resolved, c.seed));
  });
  const double size = length(c.subject.scene.momentum);
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    const auto how = fmt::format("; sampled against paths of the driven equation, at time {:.4g} of {:.4g}, {}",
                                 levels.grid().horizon, c.subject.scene.horizon, sizes[k].text());
    recorder record("weak", schemes[k].info.name, out);
    const auto written = report_levels(observables, dt, found[k], record);
    record.value({"cost", "", "path-steps", "sampled"}, at_dt(dt.back()), levels.path_steps() * sizes[k].used);
    auto order = judge_slope(expected(schemes[k]), found[k].fits.back());
    order.reason += fmt::format(" (of all {} observables together)", observables.size()) + how;
    record.verdict(weak_order_claim, std::move(order), written);
    auto limit = judge_limit(found[k].limit, levels.directions(), size);
    limit.reason += how;
    record.verdict("limit of the law is that of the Stratonovich solution", std::move(limit));
  }
  levels.log().report("weak", out);
}

}  // namespace polhode
