// SPDX-License-Identifier: Apache-2.0
// The energy law without noise: the largest distance of h from that of the true path, in units of h_0.
#include "experiments/work_precision/energy_error.hpp"
#include "selection/goal.hpp"

namespace polhode {
namespace {

constexpr double energy_rounding = 1e-13;

class energy_goal final : public goal {
 public:
  energy_goal(const context& c, const goal_question& q)
      : still_(c.subject.without_noise()), truth_(still_, q.time), time_(q.time) {}

  std::vector<candidate> candidates(const subject&) const override {
    std::vector<candidate> out;
    for (const auto& e : still_.schemes)
      out.push_back({std::string(e.info.name), e, nullptr, double(e.info.deterministic_order)});
    return out;
  }

  error_estimate error(const candidate& c, double dt, std::uint64_t) const override {
    return {truth_.error(c.scheme, dt), floor()};
  }

  const subject& priced_on(const subject&) const override { return still_; }
  double floor() const override { return energy_rounding; }
  double longest_step() const override { return time_; }
  std::string unit() const override { return "h_0"; }
  std::vector<std::string> notes() const override {
    return {
        "the energy law is that of the motion without noise, and a step is priced without; what noise does to the "
        "energy is goal weak or stationary"};
  }

 private:
  subject still_;
  energy_truth truth_;
  double time_;
};

}  // namespace

std::unique_ptr<goal> make_energy_goal(const context& c, const goal_question& q) {
  return std::make_unique<energy_goal>(c, q);
}

}  // namespace polhode
