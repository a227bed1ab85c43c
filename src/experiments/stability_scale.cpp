#include "experiments/stability_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "ensemble/paths.hpp"
#include "experiments/judge.hpp"
#include "experiments/levels.hpp"
#include "experiments/stability_case.hpp"
#include "experiments/vectors.hpp"

namespace polhode {
namespace {

constexpr double resolution = 16;  // steps to a time scale
constexpr int steps = 64;
constexpr double bound = 1e-9, decades = 150;

/// |Pi| = 4^power: by even powers of two all scalings are exact, and so is the comparison.
report::scene scaled(report::scene s, int power) {
  const double by = std::exp2(2 * power);
  for (double& x : s.momentum) x *= by;
  for (auto& v : s.sigma)
    for (double& x : v) x *= std::exp2(power);
  s.theta /= by;
  s.horizon /= by;
  return s;
}

/// One block of paths after 64 steps, in units of 4^power.
std::vector<double> states_at(const context& c, const scheme_entry& named, int power) {
  const auto s = c.subject.with(scaled(c.subject.scene, power));
  const auto& scheme = *std::ranges::find(s.schemes, named.info.name, [](const auto& e) { return e.info.name; });
  const double dt = std::ldexp(1 / (resolution * fastest_rate(c.subject)), -2 * power);
  increment_buffer noise(*s.model, steps, scheme.needs_areas, {c.generator, noise_quality::fast});
  auto states = replicated(s.scene.momentum);
  scheme.make(dt)->advance(states,
                           s.model->active_channels() > 0 ? noise.fill(c.seed, 0, 0, steps, dt) : silence(steps, dt));
  for (double& x : states) x = std::ldexp(x, -2 * power);
  return states;
}

/// Relative to the initial length, so is every other number here.
double distance_between(const std::vector<double>& a, const std::vector<double>& b, double length) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double apart = std::fabs(a[i] - b[i]) / length;
    worst = std::isfinite(apart) ? std::max(worst, apart) : std::numeric_limits<double>::infinity();
  }
  return worst;
}

/// The last power between 0, where all is well, and `far`, where it is not, at which it still is.
template <class Good>
int last_good(int far, const Good& good) {
  int near = 0;
  while (std::abs(far - near) > 1) {
    const int middle = (near + far) / 2;
    (good(middle) ? near : far) = middle;
  }
  return near;
}

}  // namespace

void report_scale(const context& c, const scheme_entry& scheme, report::results& out) {
  const double own = length(c.subject.scene.momentum);
  const auto start = states_at(c, scheme, 0);
  const auto off = [&](int power) { return distance_between(states_at(c, scheme, power), start, own); };
  const auto good = [&](int power) { return off(power) <= bound; };
  double worst = 0;
  std::string reach;
  for (const double end : {-decades, decades}) {
    const int far = static_cast<int>(std::lround((end - std::log10(own)) / std::log10(4)));
    const double apart = off(far);
    worst = std::max(worst, apart);
    const int reached = apart <= bound ? far : last_good(far, good);
    const double c_reached = own * std::exp2(2 * reached);
    reach += fmt::format("{}{:.0e}", reach.empty() ? "" : " to ", c_reached);
    out.measurements.push_back(stability_row(scheme.info.name, end < 0 ? "scale_free_from" : "scale_free_to", "c",
                                             c_reached, "momentum", "deterministic"));
  }
  auto v = judge_distance({"stability", std::string(scheme.info.name), "scale-free for |Pi| from 1e-150 to 1e150"},
                          {worst, worst, worst}, bound,
                          fmt::format("off by at most {:.1e}; the same from |Pi| = {}", worst, reach));
  if (!std::isfinite(worst)) v.kind = report::verdict_kind::refuted;
  out.verdicts.push_back(v);
}

}  // namespace polhode
