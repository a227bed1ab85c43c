// SPDX-License-Identifier: Apache-2.0
// Averages up to a time where no operator gives them: sampled beside the driven equation, on the same noise.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/weak/weak_at_step.hpp"
#include "reports/model/errors.hpp"
#include "selection/sampled_averages.hpp"

namespace polhode {
namespace {

constexpr double coarsest_pilot = 0.5;  // of the fastest time scale: twice the step of the pilot
constexpr double most_weak_work = 1e8;  // components of steps of the driven equation, of one check: some seconds
constexpr double share_left = 0.9;      // of the tolerance that a step is to leave
constexpr std::size_t kept = 8;         // step sizes of which the truth is kept

class sampled_weak_goal final : public sampled_averages {
 public:
  sampled_weak_goal(const context& c, const goal_question& q) : sampled_averages(c, q) {
    const auto truth = truth_at(pilot_steps(), context_.seed);
    sizes_ = largest_in_time(truth->sizes(first_paths / block_lanes));
    for (const double size : sizes_)
      if (!std::isfinite(size))
        throw input_error(fmt::format("scene {}: --goal weak: paths of the driven equation are lost before t = {:g}",
                                      context_.subject.scene.name, q.time));
    const auto all = candidates(c.subject);
    std::vector<pilot> found(all.size());
    parallel_for(c.threads, static_cast<int>(all.size()), [&](int i) {
      const auto k = static_cast<std::size_t>(i);
      found[k] = pilot_of(all[k], *truth);
    });
    for (std::size_t k = 0; k < all.size(); ++k) pilots_[all[k].name] = found[k];
    refuse_unresolved();
  }

  std::vector<candidate> candidates(const subject& s) const override {
    std::vector<candidate> out;
    for (const auto& e : s.schemes)
      out.push_back({std::string(e.info.name), e, nullptr, weak_order_on(e.info, s.model->noise())});
    return out;
  }
  double longest_step() const override { return question_.time; }
  /// Areas are those of the path, from the cells of the truth.
  double further_normals(const candidate& c, double dt) const override {
    const int channels = context_.subject.model->layout().active;
    return c.scheme.needs_areas && channels > 1 ? (truth_at(steps_of(dt), context_.seed)->cells() - 1.0) * channels : 0;
  }
  std::string unit() const override { return "root mean square of each observable over paths"; }
  std::vector<std::string> notes() const override {
    return {fmt::format(
        "sampled: the worst of {} at up to {} times up to t = {:g}, each in units of its root mean square over paths; "
        "against the driven equation on the same noise, with 95 % intervals of at most a sixth of the tolerance at the "
        "step and a third below it (or a tenth of the error). Levy areas, where a scheme takes them, are those of the "
        "path, from the cells inside a step: these cells are part of its cost",
        asked_in_words(), weak_at_step::most_times, question_.time)};
  }

 private:
  struct pilot {
    double error = 0, deviation = 0;  ///< of the worst observable, at the pilot's step
  };
  struct entry {
    std::pair<int, std::uint64_t> at;
    std::shared_ptr<weak_at_step> truth;
  };

  int steps_of(double dt) const { return static_cast<int>(std::lround(question_.time / dt)); }
  int pilot_steps() const {
    return 2 * static_cast<int>(std::ceil(std::max(1.0, question_.time * rate_ / coarsest_pilot) * (1 - 1e-12)));
  }

  std::shared_ptr<weak_at_step> truth_at(int steps, std::uint64_t seed) const {
    const std::lock_guard lock(keeping_);
    const std::pair at{steps, seed};
    const auto found = std::ranges::find(truths_, at, &entry::at);
    if (found != truths_.end()) return found->truth;
    if (truths_.size() == kept) truths_.erase(truths_.begin());
    truths_.push_back(
        {at, std::make_shared<weak_at_step>(context_, seed, observables_, question_.time, steps, rate_, most_paths)});
    return truths_.back().truth;
  }

  std::vector<double> largest_in_time(const std::vector<double>& all) const {
    std::vector<double> out(observables_.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      auto& size = out[k % out.size()];
      if (!(all[k] <= size)) size = all[k];
    }
    return out;
  }

  error_estimate estimate(const candidate& c, double dt, std::uint64_t seed, double width) const override {
    const auto truth = truth_at(steps_of(dt), seed);
    squared_errors all{0, truth->columns(), {}};
    return until_tight(dt, width, [&](int paths) {
      grow(all, paths, c.scheme, *truth);
      return worst_of(truth->controlled(all), sizes_, observables_, truth->times());
    });
  }
  static void grow(squared_errors& all, int paths, const scheme_entry& scheme, weak_at_step& truth) {
    const int before = std::exchange(all.paths, paths);
    all.values.resize(static_cast<std::size_t>(paths) * static_cast<std::size_t>(all.levels));
    truth.run(scheme, before / block_lanes, paths / block_lanes, all);
  }

  pilot pilot_of(const candidate& c, weak_at_step& truth) const {
    squared_errors all{0, truth.columns(), {}};
    grow(all, first_paths, c.scheme, truth);
    const auto found = worst_of(truth.controlled(all), sizes_, observables_, truth.times());
    const double error = found.uncertainty / 1.96;
    return {std::max(found.value, error), error * std::sqrt(double(first_paths))};
  }

  double work_of_a_path(double dt) const override {
    return truth_at(steps_of(dt), context_.seed)->work() * context_.subject.model->dimension();
  }
  double affordable_work() const override { return most_weak_work; }
  double deviation(const candidate& c, double dt) const override {
    const double found = pilots_.at(c.name).deviation;
    return std::isfinite(found) ? found * dt * pilot_steps() / question_.time : 0;
  }
  bool resolves(double tolerance) const override {
    return std::ranges::any_of(candidates(context_.subject), [&](const candidate& c) {
      const auto& p = pilots_.at(c.name);
      if (!std::isfinite(p.error)) return false;
      const double step = question_.time / pilot_steps() * std::pow(share_left * tolerance / p.error, 1 / c.order);
      return affordable_at(c, question_.time / std::ceil(std::max(1.0, question_.time / step)), tolerance);
    });
  }

  std::vector<double> sizes_;
  std::map<std::string, pilot> pilots_;
  mutable std::mutex keeping_;
  mutable std::vector<entry> truths_;
};

}  // namespace

std::unique_ptr<goal> make_sampled_weak_goal(const context& c, const goal_question& q) {
  return std::make_unique<sampled_weak_goal>(c, q);
}

}  // namespace polhode
