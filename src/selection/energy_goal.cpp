// The energy law without noise: the largest distance of h from that of the true path, at eight times, in units of h_0.
#include <cmath>

#include "ensemble/paths.hpp"
#include "experiments/levels.hpp"
#include "references/odeint.hpp"
#include "selection/goal.hpp"

namespace polhode {
namespace {

constexpr int times = 8;
constexpr double rounding = 1e-13;

class energy_goal final : public goal {
 public:
  energy_goal(const context& c, const goal_question& q)
      : still_(c.subject.without_noise()),
        time_(q.time),
        unit_(std::max(std::fabs(still_.model->energy(still_.scene.momentum)), 1e-300)) {}

  std::vector<candidate> candidates(const subject&) const override {
    std::vector<candidate> out;
    for (const auto& e : still_.schemes)
      out.push_back({std::string(e.info.name), e, nullptr, double(e.info.deterministic_order)});
    return out;
  }

  error_estimate error(const candidate& c, double dt, std::uint64_t) const override {
    const auto stepper = c.scheme.make(dt);
    const auto steps = std::lround(time_ / dt);
    auto states = replicated(still_.scene.momentum);
    double worst = 0;
    long done = 0;
    for (int k = 1; k <= times; ++k) {
      const long next = steps * k / times;
      if (next == done) continue;
      stepper->advance(states, silence(static_cast<int>(next - done), dt));
      done = next;
      const double h = still_.model->energy(lane_of(states, 0, still_.model->dimension()));
      worst = std::isfinite(h) ? std::max(worst, std::fabs(h - true_energy(static_cast<double>(done) * dt))) : h;
      if (!std::isfinite(h)) break;
    }
    return {worst / unit_, floor()};
  }

  double floor() const override { return rounding; }
  double longest_step() const override { return time_; }
  std::string unit() const override { return "h_0"; }
  std::vector<std::string> notes() const override {
    return {
        "the energy law is that of the motion without noise; what noise does to the energy is goal weak or "
        "stationary"};
  }

 private:
  double true_energy(double t) const {
    return still_.model->energy(
        solve_drift([&](std::span<const double> mu, std::span<double> out) { still_.model->drift(mu, out); },
                    still_.scene.momentum, t));
  }

  subject still_;
  double time_, unit_;
};

}  // namespace

std::unique_ptr<goal> make_energy_goal(const context& c, const goal_question& q) {
  return std::make_unique<energy_goal>(c, q);
}

}  // namespace polhode
