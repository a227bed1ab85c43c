#include "experiments/weak_sampled.hpp"

#include <fmt/format.h>

#include <cmath>

#include "experiments/increment_ladder.hpp"
#include "experiments/sequential.hpp"

namespace polhode {
namespace {

constexpr int cells = 8;     // in the finest step of several channels, so that no scheme changes another's noise
constexpr double clear = 5;  // standard errors
constexpr double resolution = 64;

/// Of one scheme: differences of one observable between a level and the next finer one, path by path.
using differences = std::vector<squared_errors>;  // [observable], values are not squares here

using kernel_row = std::vector<std::unique_ptr<kernel>>;  // [level]

class coupled_levels {
 public:
  coupled_levels(const context& c, const std::vector<scheme_entry>& schemes, const std::vector<sphere_function>& f,
                 int paths)
      : context_(c),
        grid_(asymptotic_levels(c.subject, resolution)),
        cells_(c.subject.model->active_channels() > 1 ? cells : 1),
        functions_(f),
        found_(schemes.size()) {
    const int pairs = static_cast<int>(grid_.steps.size()) - 1;
    for (std::size_t k = 0; k < schemes.size(); ++k) {
      found_[k].assign(f.size(), {paths, pairs, std::vector<double>(static_cast<std::size_t>(paths * pairs))});
      kernels_.emplace_back();
      for (const double dt : grid_.dt()) kernels_[k].push_back(schemes[k].make(dt));
    }
  }

  /// dt of the coarser of each two levels.
  std::vector<double> dt() const {
    auto out = grid_.dt();
    out.pop_back();
    return out;
  }
  double path_steps() const {
    double sum = 0;
    for (const int n : grid_.steps) sum += n;
    return sum;
  }
  differences& of(int scheme) { return found_[static_cast<std::size_t>(scheme)]; }

  void run_block(int block, std::span<const int> open) {
    const auto& s = context_.subject;
    increment_ladder ladder(*s.model, grid_, cells_, {context_.generator, noise_quality::fast});
    const auto first = static_cast<std::uint64_t>(block * block_lanes);
    const std::vector<std::vector<double>> start(grid_.steps.size(), replicated(s.scene.momentum));
    std::vector<std::vector<std::vector<double>>> states(open.size(), start);
    for (int chunk = 0; chunk < grid_.steps.front(); ++chunk) {
      ladder.fill(context_.seed, first, chunk);
      for (std::size_t i = 0; i < open.size(); ++i)
        for (std::size_t l = 0; l < start.size(); ++l)
          kernels_[static_cast<std::size_t>(open[i])][l]->advance(states[i][l], ladder.level(l));
    }
    for (std::size_t i = 0; i < open.size(); ++i) keep(states[i], block * block_lanes, of(open[i]));
  }

 private:
  void keep(const std::vector<std::vector<double>>& states, int first_path, differences& out) const {
    for (int lane = 0; lane < block_lanes; ++lane)
      for (std::size_t f = 0; f < functions_.size(); ++f)
        for (std::size_t l = 0; l + 1 < states.size(); ++l)
          out[f].at(first_path + lane, static_cast<int>(l)) = value(f, states[l], lane) - value(f, states[l + 1], lane);
  }
  double value(std::size_t f, const std::vector<double>& states, int lane) const {
    const auto at = lane_of(states, lane, 3);
    return functions_[f](Eigen::Vector3d(at.data()));
  }

  const context& context_;
  level_grid grid_;
  int cells_;
  const std::vector<sphere_function>& functions_;
  std::vector<kernel_row> kernels_;
  std::vector<differences> found_;
};

void report_levels(const series& s, std::span<const double> dt, const squared_errors& d,
                   const std::optional<order_fit>& found, report::results& out) {
  std::vector<report::measurement> points;
  auto variance = s;
  variance.quantity = "variance of the difference";
  for (int l = 0; l < d.levels; ++l) {
    const auto m = level_mean(d, l);
    const double size = std::fabs(m.mean), step = dt[static_cast<std::size_t>(l)];
    points.push_back(measured(s, step, size, std::max(0.0, size - 1.96 * m.error), size + 1.96 * m.error));
    out.measurements.push_back(measured(variance, step, m.error * m.error * d.paths, {}, {}));
  }
  record_fit(out, s, found, std::move(points));
}

}  // namespace

void report_sampled_orders(const context& c, const std::vector<scheme_entry>& schemes, const order_question& q,
                           const std::vector<sphere_function>& functions, report::results& out) {
  const sampling_plan plan{1024, by_effort(c.effort, 4096, 16384, 65536)};
  coupled_levels levels(c, schemes, functions, blocks_of(plan.most) * block_lanes);
  const auto dt = levels.dt();
  std::vector<std::vector<std::optional<order_fit>>> fits(schemes.size());
  const auto sizes = sample_until_tight(
      c, plan, static_cast<int>(schemes.size()),
      [&](int block, std::span<const int> open) { levels.run_block(block, open); },
      [&](int scheme, int so_far) {
        auto& found = fits[static_cast<std::size_t>(scheme)];
        found.clear();
        for (auto& d : levels.of(scheme)) {
          d.paths = so_far;
          found.push_back(fit_order_of_clear_means(dt, d, clear, c.seed));
        }
        return std::ranges::all_of(found, [](const auto& f) { return f && half_width(*f) <= tight_order; });
      });
  for (std::size_t k = 0; k < schemes.size(); ++k) {
    const std::string name(schemes[k].info.name);
    for (std::size_t f = 0; f < functions.size(); ++f)
      report_levels({q.experiment, name, "difference", q.columns[f].observable, "", "sampled"}, dt,
                    levels.of(static_cast<int>(k))[f], fits[k][f], out);
    out.measurements.push_back(measured({q.experiment, name, "cost", "", "path-steps", "sampled"}, dt.back(),
                                        levels.path_steps() * sizes[k].used, {}, {}));
    auto v = judge_columns(q, q.expected(schemes[k]), name, fits[k]);
    v.reason += fmt::format("; sampled by coupled levels, {}", sizes[k].text());
    out.verdicts.push_back(std::move(v));
  }
}

}  // namespace polhode
