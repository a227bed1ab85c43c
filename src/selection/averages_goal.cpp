// Averages, after a time or at equilibrium: by transfer operators, nothing sampled.
#include <fmt/format.h>

#include <cmath>

#include "experiments/transfer_report.hpp"
#include "reports/model/errors.hpp"
#include "selection/goal.hpp"

namespace polhode {
namespace {

constexpr double tolerance = 0.02, extrapolated_tolerance = 1e-6;  // of an error
constexpr const extrapolation& combination = extrapolations.front();
constexpr double reference_accuracy = 1e-12, rounding = 1e-12;  // of the observable's size

class averages_goal final : public goal {
 public:
  averages_goal(const context& c, const goal_question& q)
      : context_(c), question_(q), stationary_(q.name == "stationary"), problem_(*sphere_problem_of(c.subject)) {
    const auto f = named_observable(q.observable, c.subject.scene.inertia);
    if (!f) throw input_error(fmt::format("--observable '{}': not known; see polhode list observables", q.observable));
    function_ = *f;
    const auto& momentum = c.subject.scene.momentum;
    start_ = Eigen::Map<const Eigen::Vector3d>(momentum.data());
    scale_ = std::max(std::fabs(function_(start_)), 1e-3 * problem_.radius * problem_.radius);
    const auto truth = stationary_ ? mean(problem_, stationary(problem_, reference_accuracy), function_)
                                   : expectation(problem_, function_, start_, q.time, reference_accuracy * scale_);
    if (q.tolerance >= 10 * floor() && (!truth.value || truth.uncertainty > q.tolerance / 20))
      throw input_error(fmt::format("scene {}: the true average of {} is {}; a tolerance of {:g} cannot be checked",
                                    c.subject.scene.name, q.observable,
                                    truth.value ? fmt::format("known to {:.1e} only", truth.uncertainty) : truth.reason,
                                    q.tolerance));
    truth_ = truth;
  }

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

  std::optional<std::string> cannot_ask(const candidate& c) const override {
    if (stationary_ && !c.scheme.info.casimir.exact) return "leaves the sphere, so it has no stationary law there";
    return std::nullopt;
  }

  error_estimate error(const candidate& c, double dt, std::uint64_t) const override {
    error_table found{c.name, {}, {}, {}};
    found.add(dt, answer(c, dt));
    if (c.combination != nullptr) {
      for (int i = 1; i < c.combination->levels(); ++i) found.add(dt / (1 << i), answer(c, dt / (1 << i)));
      found = extrapolate(found, *c.combination);
    }
    return {std::fabs(found.error[0][0]), found.uncertainty[0][0] + truth_.uncertainty};
  }

  double floor() const override { return rounding * scale_; }
  double longest_step() const override { return stationary_ ? 4 / fastest_rate(context_.subject) : question_.time; }

  std::vector<std::string> notes() const override {
    std::vector<std::string> out{fmt::format("true {} of {}: {:.10g} (+- {:.1e})",
                                             stationary_ ? "stationary mean" : "mean", question_.observable,
                                             *truth_.value, truth_.uncertainty)};
    if (stationary_ && context_.subject.model->noise() != noise_class::isotropic)
      out.push_back(
          "the noise is not isotropic: no Gibbs law holds, and no temperature; the mean above is that of the "
          "true stationary law");
    return out;
  }

 private:
  transfer_answer answer(const candidate& c, double dt) const {
    const auto steps = static_cast<std::int64_t>(std::lround((stationary_ ? 1 : question_.time) / dt));
    const transfer_question q{[&](const transfer_operator& op) -> Eigen::VectorXd {
                                const auto law = stationary_ ? op.stationary_law() : op.law_after(start_, steps);
                                return Eigen::VectorXd::Constant(1, law.dot(op.basis.coefficients(function_)));
                              },
                              {Eigen::VectorXd::Constant(1, *truth_.value), Eigen::VectorXd::Constant(1, scale_),
                               c.combination != nullptr ? extrapolated_tolerance : tolerance}};
    return refine(context_.subject, c.scheme, dt, std::max<std::int64_t>(steps, 1), q);
  }

  context context_;
  goal_question question_;
  bool stationary_;
  sphere_problem problem_;
  sphere_function function_;
  Eigen::Vector3d start_;
  double scale_ = 1;
  reference_value truth_;
};

}  // namespace

std::unique_ptr<goal> make_averages_goal(const context& c, const goal_question& q) {
  return std::make_unique<averages_goal>(c, q);
}

}  // namespace polhode
