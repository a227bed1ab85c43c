// SPDX-License-Identifier: Apache-2.0
#include "selection/sampled_averages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ensemble/kernel.hpp"
#include "experiments/common/levels.hpp"
#include "reports/model/errors.hpp"

namespace polhode {
namespace {

constexpr std::size_t components = 6;  // of a long state
constexpr double relative = 0.1;       // of an error: known better than that it need not be
constexpr double average_quantile = 1.96;
constexpr double nothing = 1e-12;  // of the largest size: an observable that vanishes

std::vector<observable> observables_for(const subject& s, const std::string& asked) {
  auto out = observables_of(s, components);
  if (asked == all_observables || std::ranges::find(out, asked, &observable::name) != out.end()) return out;
  const auto f = observable_of(s, asked);
  if (!f) throw input_error(fmt::format("--observable '{}': not known; see polhode list observables", asked));
  out.push_back({asked, *f});
  return out;
}

}  // namespace

sampled_averages::sampled_averages(const context& c, const goal_question& q)
    : context_(c),
      question_(q),
      rate_(fastest_rate(c.subject)),
      observables_(observables_for(c.subject, q.observable)) {}

double sampled_averages::paths_needed(const candidate& c, double dt, double tolerance) const {
  const double needed = std::pow(average_quantile * deviation(c, dt) / (fine * tolerance), 2);
  return std::max(needed, double(first_paths));
}

bool sampled_averages::affordable_at(const candidate& c, double dt, double tolerance) const {
  const double paths = paths_needed(c, dt, tolerance);
  return paths <= most_paths && paths * work_of_a_path(dt) <= affordable_work();
}

bool sampled_averages::affordable(const candidate& c, double dt) const {
  return affordable_at(c, dt, question_.tolerance);
}

std::string sampled_averages::dear_check(const candidate& c, double dt) const {
  return fmt::format("needs about {:.1e} paths at dt = {:.2g} to be checked", paths_needed(c, dt, question_.tolerance),
                     dt);
}

void sampled_averages::refuse_unresolved() const {
  if (resolves(question_.tolerance)) return;
  const auto refuse = [&](const std::string& accepted) {
    throw input_error(
        fmt::format("scene {}: --tolerance '{:g}': sampling does not resolve it at an affordable cost; accepted: {}",
                    context_.subject.scene.name, question_.tolerance, accepted));
  };
  for (int power = -8; power <= 0; ++power)
    for (const double digit : {1.0, 1.5, 2.0, 3.0, 5.0, 7.0})
      if (const double t = digit * std::pow(10.0, power); t > question_.tolerance && resolves(t))
        refuse(fmt::format("{:g} or more", t));
  refuse("none, as paths scatter too much here");
}

error_estimate sampled_averages::until_tight(double dt, double share,
                                             const std::function<error_estimate(int paths)>& at) const {
  const double affordable = affordable_work() / work_of_a_path(dt);
  const int most = static_cast<int>(std::clamp(affordable, double(first_paths), double(most_paths)));
  for (int paths = first_paths;; paths *= 2) {
    auto found = at(paths);
    const double wanted = std::max(share * question_.tolerance, relative * found.value);
    if (!std::isfinite(found.bound()) || found.uncertainty <= wanted || 2 * paths > most) return found;
  }
}

error_estimate sampled_averages::worst_of(const squared_errors& d, const std::vector<double>& sizes,
                                          const std::vector<observable>& of, const std::vector<double>& times) const {
  error_estimate out;
  const double vanishing = nothing * *std::ranges::max_element(sizes);
  for (std::size_t f = 0; f < of.size(); ++f) {
    observable_error worst{of[f].name, 0, 0, 0};
    if (!(sizes[f] <= vanishing))
      for (std::size_t t = 0; t < times.size(); ++t) {
        const auto m = level_mean(d, static_cast<int>(t * of.size() + f));
        const double value = std::fabs(m.mean) / sizes[f], half = average_quantile * m.error / sizes[f];
        if (!(value + half <= worst.bound())) worst = {of[f].name, value, half, times[t]};
        if (!std::isfinite(value)) break;
      }
    if (asked(worst.observable) && std::isfinite(out.bound()) && !(worst.bound() <= out.bound())) {
      out.value = worst.value;
      out.uncertainty = worst.uncertainty;
    }
    out.observed.push_back(std::move(worst));
  }
  return out;
}

std::string sampled_averages::asked_in_words() const {
  if (question_.observable != all_observables) return question_.observable;
  return context_.subject.scene.momentum.size() > components
             ? fmt::format("the energy, the first {} components and their squares", components)
             : "the energy, the components and their squares";
}

}  // namespace polhode
