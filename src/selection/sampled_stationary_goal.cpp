// SPDX-License-Identifier: Apache-2.0
// Averages at equilibrium where no operator gives them: long runs against the exact means of the Gibbs law.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ensemble/kernel.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/gibbs/long_runs.hpp"
#include "reports/model/errors.hpp"
#include "selection/sampled_averages.hpp"

namespace polhode {
namespace {

constexpr double usual = 0.25;                // of the fastest time scale: a step that is to be asked for at least
constexpr double most_stationary_work = 4e8;  // components of steps, of one check: some seconds

class sampled_stationary_goal final : public sampled_averages {
 public:
  sampled_stationary_goal(const context& c, const goal_question& q) : sampled_averages(c, q), runs_(c, observables_) {
    const auto refuse = [&](const std::string& fault) {
      throw input_error(fmt::format("scene {}: --goal stationary: {}; ask --goal weak", c.subject.scene.name, fault));
    };
    if (!runs_.reason().empty()) refuse(runs_.reason());
    bool known = false;
    for (std::size_t f = 0; f < runs_.observables().size(); ++f) {
      sizes_.push_back(runs_.size(f));
      if (!asked(runs_.observables()[f].name)) continue;
      known = true;
      deviation_ = std::max(deviation_, runs_.deviation(f) / sizes_[f]);
      if (runs_.uncertainty(f) > q.tolerance / 20 * sizes_[f])
        refuse(fmt::format("the mean of {} is known to {:.1e} of its size only", runs_.observables()[f].name,
                           runs_.uncertainty(f) / sizes_[f]));
    }
    if (!known) refuse(fmt::format("the mean of {} under the Gibbs law is not known", q.observable));
    refuse_unresolved();
  }

  std::vector<candidate> candidates(const subject& s) const override {
    std::vector<candidate> out;
    for (const auto& e : s.schemes)
      out.push_back({std::string(e.info.name), e, nullptr, weak_order_on(e.info, s.model->noise())});
    return out;
  }
  std::optional<std::string> cannot_ask(const candidate& c) const override {
    if (!c.scheme.info.casimir.exact) return "leaves the orbit, so it has no stationary law there";
    return std::nullopt;
  }
  double longest_step() const override { return longest_at_equilibrium(context_.subject); }
  std::string unit() const override { return "root mean square of each observable under the Gibbs law"; }
  std::vector<std::string> notes() const override {
    std::vector<std::string> names;
    for (const auto& f : runs_.observables()) names.push_back(f.name);
    const double worth = long_runs::worth_of_a_path();
    return {fmt::format(
        "sampled: the worst of {} in long runs against the exact means of the Gibbs law, each in units of its root "
        "mean "
        "square under it, with 95 % intervals of at most a sixth of the tolerance at the step and a third below it (or "
        "a tenth of the error). A path forgets its start for three and is averaged over twenty autocorrelation times "
        "of "
        "the slowest observable, {:.3g}: worth {:g} independent samples, of which {:.1e} at most are needed",
        question_.observable == all_observables ? fmt::format("{}", fmt::join(names, ", ")) : question_.observable,
        runs_.relaxation_time(), worth,
        worth * std::max(double(first_paths),
                         std::pow(1.96 * deviation_ / std::sqrt(worth) / (fine * question_.tolerance), 2)))};
  }

 private:
  error_estimate estimate(const candidate& c, double dt, std::uint64_t seed, double width) const override {
    squared_errors all{0, static_cast<int>(sizes_.size()), {}};
    return until_tight(dt, width, [&](int paths) {
      const int before = std::exchange(all.paths, paths);
      all.values.resize(static_cast<std::size_t>(paths) * sizes_.size());
      runs_.run(c.scheme, dt, seed, before / block_lanes, paths / block_lanes, all);
      return worst_of(all, sizes_, runs_.observables(), {0});
    });
  }
  double work_of_a_path(double dt) const override {
    return runs_.steps_of_a_path(dt) * context_.subject.model->dimension();
  }
  double affordable_work() const override { return most_stationary_work; }
  double deviation(const candidate&, double) const override {
    return deviation_ / std::sqrt(long_runs::worth_of_a_path());
  }
  bool resolves(double tolerance) const override { return affordable_at({}, usual / rate_, tolerance); }

  long_runs runs_;
  std::vector<double> sizes_;
  double deviation_ = 0;  ///< the largest of those asked for, in units of the observable's size
};

}  // namespace

std::unique_ptr<goal> make_sampled_stationary_goal(const context& c, const goal_question& q) {
  return std::make_unique<sampled_stationary_goal>(c, q);
}

}  // namespace polhode
