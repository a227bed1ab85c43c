// SPDX-License-Identifier: Apache-2.0
#include "experiments/weak/true_means.hpp"

#include <fmt/format.h>

#include "experiments/common/undecided.hpp"
#include "sphere/expectations/expectation.hpp"

namespace polhode {
namespace {

constexpr double reference_accuracy = 1e-13;  // of an observable's size

/// The column of f, whose true expectation is `exact`, with what moves it: difference quotients, no better than their
/// share need be.
error_column column_of(const subject& s, const sphere_problem& p, const char* name, const sphere_function& f,
                       double scale, double exact) {
  constexpr double accuracy = 1e-8;
  const auto moved = [&](const sphere_problem& other) {
    const auto value = expectation(other, f, start_of(s), s.scene.horizon, accuracy * scale);
    return value.value && value.uncertainty <= usable_truth * scale ? (*value.value - exact) / sensitivity_share : 0;
  };
  return {"error", name, scale, moved(with_more_noise(p, sensitivity_share)),
          p.damping > 0 ? moved(with_more_dissipation(p, sensitivity_share)) : 0};
}

}  // namespace

Eigen::Vector3d start_of(const subject& s) { return Eigen::Map<const Eigen::Vector3d>(s.scene.momentum.data()); }

true_means true_means_of(const subject& s, report::results& out) {
  const auto problem = *s.sphere();
  true_means t;
  for (const char* name : weak_observables) {
    const auto f = *named_observable(name, problem);
    const double scale = size_on_sphere(f, problem.radius);
    const auto value = expectation(problem, f, start_of(s), s.scene.horizon, reference_accuracy * scale);
    if (!value.value || value.uncertainty > usable_truth * scale) {
      leave_open(s.schemes, "weak", fmt::format("weak order of E[{}]", name), "its true value is " + value.reason, out);
      continue;
    }
    t.columns.push_back(column_of(s, problem, name, f, scale, *value.value));
    t.functions.push_back(f);
    t.exact.push_back(*value.value);
    t.uncertainty.push_back(value.uncertainty);
  }
  return t;
}

transfer_target true_means::target(double accuracy) const {
  const auto count = static_cast<Eigen::Index>(columns.size());
  return {
      Eigen::Map<const Eigen::VectorXd>(exact.data(), count),
      Eigen::VectorXd::NullaryExpr(count, [&](Eigen::Index i) { return columns[static_cast<std::size_t>(i)].scale; }),
      accuracy};
}

}  // namespace polhode
