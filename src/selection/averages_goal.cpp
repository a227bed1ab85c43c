// SPDX-License-Identifier: Apache-2.0
// Averages, up to a time or at equilibrium, each in its own size: by transfer operators, nothing sampled.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/common/levels.hpp"
#include "experiments/laws/transfer_report.hpp"
#include "experiments/work_precision/combined_law_error.hpp"
#include "reports/model/errors.hpp"
#include "selection/goal.hpp"

namespace polhode {
namespace {

constexpr double tolerance = 0.02, rough_tolerance = 0.1;  // of an error
constexpr const extrapolation& combination = extrapolations.front();
constexpr double reference_accuracy = 1e-12, averages_rounding = 1e-12;  // of the observable's size

/// What of an observable's truth is uncertain, in units of its size.
double most_uncertain(const law_observables& all, const Eigen::VectorXd& uncertainty, const std::string& asked) {
  double out = 0;
  for (Eigen::Index i = 0; i < all.count(); ++i)
    if (asked == all_observables || asked == all.names[static_cast<std::size_t>(i)])
      out = std::max(out, uncertainty[i] / all.size[i]);
  return out;
}

/// Weak and stationary: what differs between them is where the errors come from.
class averages_goal : public goal {
 public:
  averages_goal(const context& c, const goal_question& q) : context_(c), question_(q) {}

  std::vector<candidate> candidates(const subject& s) const override {
    std::vector<candidate> out;
    for (const auto& e : s.schemes) {
      const double order = weak_order_on(e.info, s.model->noise());
      out.push_back({std::string(e.info.name), e, nullptr, order});
      if (e.info.name == extrapolated_from)
        out.push_back({std::string(combination.name), e, &combination, combination.order});
    }
    return out;
  }

  error_estimate error(const candidate& c, double dt, std::uint64_t) const override {
    return resolved_to(tolerance, c, dt);
  }
  error_estimate rough_error(const candidate& c, double dt, std::uint64_t) const override {
    return resolved_to(rough_tolerance, c, dt);
  }

  double floor() const override { return averages_rounding; }
  std::string unit() const override { return "root mean square of each observable over the sphere"; }

 protected:
  virtual const law_observables& observables() const = 0;
  virtual law_error law_error_at(const candidate&, double dt, double relative, std::int64_t finer) const = 0;

  error_estimate resolved_to(double relative, const candidate& c, double dt) const {
    const auto at = [&](double step, double share, std::int64_t finer) { return law_error_at(c, step, share, finer); };
    const auto found = c.combination != nullptr
                           ? combined_error(*c.combination, dt, 0, relative * question_.tolerance, at)
                           : at(dt, relative, 1);
    return worst_asked(found.worst_in_time(observables()));
  }

  error_estimate worst_asked(std::vector<observable_error> all) const {
    error_estimate out{0, 0, std::move(all)};
    for (const auto& o : out.observed)
      if (asked(o.observable) && std::isfinite(out.bound()) && !(o.bound() <= out.bound())) {
        out.value = o.value;
        out.uncertainty = o.uncertainty;
      }
    return out;
  }

  bool asked(const std::string& name) const {
    return question_.observable == all_observables || question_.observable == name;
  }
  void refuse_uncertain(double uncertainty, const std::string& reason) const {
    if (question_.tolerance < 10 * floor() || uncertainty <= question_.tolerance / 20) return;
    throw input_error(fmt::format(
        "scene {}: the true averages are {}; a tolerance of {:g} cannot be checked", context_.subject.scene.name,
        reason.empty() ? fmt::format("known to {:.1e} of their size only", uncertainty) : reason, question_.tolerance));
  }

  context context_;
  goal_question question_;
};

class weak_goal final : public averages_goal {
 public:
  weak_goal(const context& c, const goal_question& q)
      : averages_goal(c, q), law_(context_.subject, q.time, reference_accuracy) {
    refuse_uncertain(most_uncertain(law_.observables(), law_.truth().uncertainty(), q.observable),
                     law_.truth().reason());
  }
  double longest_step() const override { return question_.time; }
  std::vector<std::string> notes() const override {
    return {
        fmt::format("the worst of {} at every step up to t = {:g}, each in units of its root mean square over the "
                    "sphere; true averages known to {:.0e} of that",
                    question_.observable == all_observables ? "all observables" : question_.observable, question_.time,
                    most_uncertain(law_.observables(), law_.truth().uncertainty(), question_.observable))};
  }

 private:
  const law_observables& observables() const override { return law_.observables(); }
  law_error law_error_at(const candidate& c, double dt, double relative, std::int64_t finer) const override {
    return law_.error(c.scheme, dt, relative, finer);
  }
  weak_law law_;
};

class stationary_goal final : public averages_goal {
 public:
  stationary_goal(const context& c, const goal_question& q)
      : averages_goal(c, q), law_(context_.subject, reference_accuracy) {
    refuse_uncertain(
        law_.reason().empty() ? most_uncertain(law_.observables(), law_.uncertainty(), q.observable) : HUGE_VAL,
        law_.reason());
  }
  std::optional<std::string> cannot_ask(const candidate& c) const override {
    if (!c.scheme.info.casimir.exact) return "leaves the sphere, so it has no stationary law there";
    return std::nullopt;
  }
  double longest_step() const override { return longest_at_equilibrium(context_.subject); }
  std::vector<std::string> notes() const override {
    std::vector<std::string> out;
    out.push_back(
        fmt::format("the worst of {} under the scheme's own stationary law, each in units of its root mean square over "
                    "the sphere; true averages known to {:.0e} of that",
                    question_.observable == all_observables ? "all observables" : question_.observable,
                    most_uncertain(law_.observables(), law_.uncertainty(), question_.observable)));
    if (context_.subject.model->noise() != noise_class::isotropic)
      out.emplace_back(
          "the noise is not isotropic: no Gibbs law holds, and no temperature; the true averages are those of the true "
          "stationary law");
    return out;
  }

 private:
  const law_observables& observables() const override { return law_.observables(); }
  law_error law_error_at(const candidate& c, double dt, double relative, std::int64_t) const override {
    return law_.error(c.scheme, dt, relative);
  }
  equilibrium_law law_;
};

}  // namespace

std::unique_ptr<goal> make_averages_goal(const context& c, const goal_question& q) {
  const auto names = every_observable(c.subject).names;
  if (q.observable != all_observables && std::ranges::find(names, q.observable) == names.end())
    throw input_error(fmt::format("--observable '{}': not known; see polhode list observables", q.observable));
  if (q.name == "weak") return std::make_unique<weak_goal>(c, q);
  return std::make_unique<stationary_goal>(c, q);
}

}  // namespace polhode
