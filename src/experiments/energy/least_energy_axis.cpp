#include "experiments/energy/least_energy_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "experiments/common/undecided.hpp"
#include "problem/vectors.hpp"

namespace polhode {
namespace {

constexpr double end_bound = 1e-6;  // of the energy's range: how near the least energy a path must end
constexpr int least_axis_time_scales = 60;
constexpr double most_end_steps = 1e6;
constexpr const char* end_claim = "ends on the axis of least energy";

}  // namespace

void report_end(const subject& s, const scheme_entry& scheme, report::results& out) {
  const auto [least, greatest] = std::ranges::minmax(s.scene.vector("inertia"));
  const double c = length(s.scene.momentum), range = 0.5 * c * c * (1 / least - 1 / greatest);
  const double rate = fastest_rate(s);
  // The slowest decay: between the two axes of greatest inertia, at rate theta c^2 times their difference of 1/I.
  auto inertia = s.scene.vector("inertia");
  std::ranges::sort(inertia);
  const double gap = inertia[2] > inertia[1] ? 1 / inertia[1] - 1 / inertia[2] : 1 / inertia[0] - 1 / inertia[2];
  const double time = least_axis_time_scales / (s.scene.number("theta") * c * c * gap), dt = 0.05 / rate;
  const std::string name(scheme.info.name);
  if (time / dt > most_end_steps) {
    leave_open(
        {&scheme, 1}, "energy", end_claim,
        fmt::format("the slowest decay needs {:.1e} steps, at most {:g} are affordable", time / dt, most_end_steps),
        out);
    return;
  }
  const int steps = static_cast<int>(time / dt);
  const auto stepper = scheme.make(dt);
  auto states = replicated(s.scene.momentum);
  stepper->advance(states, silence(steps, dt));
  const auto end = lane_of(states, 0, s.model->dimension());
  // Energy of the direction reached, above the least on its sphere.
  const double e = length(end), above = (s.model->energy(end) * c * c / (e * e) - 0.5 * c * c / greatest) / range;
  out.verdicts.push_back(
      judge_distance({"energy", name, end_claim}, {above, above, above}, end_bound,
                     fmt::format("after time {:.3g}: {:.1e} of the energy's range above the least", time, above)));
}

}  // namespace polhode
