// SPDX-License-Identifier: Apache-2.0
#include "selection/goal.hpp"

#include <fmt/format.h>

#include <cmath>

#include "experiments/common/levels.hpp"
#include "reports/model/errors.hpp"
#include "transfer/transfer.hpp"

namespace polhode {

namespace {

std::unique_ptr<goal> averages_of(const context& c, const goal_question& q) {
  if (c.subject.sphere()) return make_averages_goal(c, q);
  return q.name == "weak" ? make_sampled_weak_goal(c, q) : make_sampled_stationary_goal(c, q);
}

}  // namespace

std::string goal::dear_check(const candidate&, double dt) const {
  return fmt::format("needs about {:.1e} steps to be checked", longest_step() / dt);
}

std::unique_ptr<goal> make_goal(const context& c, const goal_question& q) {
  const auto& s = c.subject;
  const auto refuse = [&](const std::string& fault) {
    throw input_error(fmt::format("scene {}: --goal {}: {}", s.scene.name, q.name, fault));
  };
  if (!(q.tolerance > 0) || !std::isfinite(q.tolerance))
    throw input_error(fmt::format("--tolerance '{:g}': accepted: a number above 0", q.tolerance));
  const bool averages = q.name == "weak" || q.name == "stationary";
  if (q.name != "energy" && s.model->noise() == noise_class::none)
    refuse("the scene has no noise, so its path is its law; ask --goal energy, or polhode verify --experiments energy");
  if (const double scales = fastest_rate(s) * q.time; q.name != "stationary" && scales > most_time_scales)
    refuse(fmt::format("time = {:g} is {:.2g} of the fastest time scales; accepted: at most {:g}, --time up to {:.3g}",
                       q.time, scales, most_time_scales, most_time_scales / fastest_rate(s)));
  if (!averages && q.observable != all_observables)
    throw input_error(fmt::format("--observable '{}': of --goal weak and stationary; goal {} is asked of the {}",
                                  q.observable, q.name, q.name == "strong" ? "path" : "energy"));
  auto made = averages ? averages_of(c, q) : q.name == "strong" ? make_path_goal(c, q) : make_energy_goal(c, q);
  if (q.tolerance < 10 * made->floor())
    throw input_error(
        fmt::format("--tolerance '{:g}': below what double precision can show here; accepted: {:.1g} or "
                    "more",
                    q.tolerance, 10 * made->floor()));
  return made;
}

}  // namespace polhode
