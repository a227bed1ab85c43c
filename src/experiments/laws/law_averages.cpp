// SPDX-License-Identifier: Apache-2.0
#include "experiments/laws/law_averages.hpp"

#include <algorithm>
#include <array>

#include "experiments/laws/transfer_report.hpp"
#include "experiments/laws/true_law.hpp"
#include "sphere/expectations/expectation.hpp"

namespace polhode {
namespace {

constexpr std::array at_horizon{"energy", "pi1", "pi2", "pi3", "pi1^2", "pi3^2", "exp(pi3)"};
constexpr std::array in_the_long_run{"energy", "pi1^2", "exp(pi3)"};
constexpr double accuracy = 1e-11;  // of an observable's size

using found_average = std::pair<std::string, reference_value>;

exact_averages collect(const sphere_problem& p, const std::vector<found_average>& found) {
  exact_averages out;
  std::vector<double> value, uncertainty, size;
  for (const auto& [name, average] : found) {
    if (!average.converged()) continue;
    const auto f = *named_observable(name, p);
    out.names.push_back(name);
    out.functions.push_back(f);
    value.push_back(*average.value);
    uncertainty.push_back(average.uncertainty);
    size.push_back(size_on_sphere(f, p.radius));
    out.degree = std::max(out.degree, average.degree);
  }
  const auto count = static_cast<Eigen::Index>(value.size());
  out.value = Eigen::Map<Eigen::VectorXd>(value.data(), count);
  out.uncertainty = Eigen::Map<Eigen::VectorXd>(uncertainty.data(), count);
  out.size = Eigen::Map<Eigen::VectorXd>(size.data(), count);
  return out;
}

}  // namespace

Eigen::VectorXd law_averages::of(const transfer_operator& op, const Eigen::Vector3d& start, std::int64_t steps) const {
  Eigen::VectorXd out(count());
  Eigen::Index i = 0;
  const auto add = [&](const exact_averages& averages, const Eigen::RowVectorXd& law) {
    for (const auto& f : averages.functions) out[i++] = law.dot(op.basis.coefficients(f));
  };
  if (at_horizon.count() > 0) add(at_horizon, op.law_after(start, steps));
  if (stationary.count() > 0) add(stationary, op.stationary_law());
  return out;
}

law_averages averages_on(const subject& s) {
  law_averages out;
  const auto& p = *s.sphere();
  if (s.model->noise() == noise_class::none) {
    out.no_horizon = out.no_law = "no noise: an average is a value on the one path there is (experiment energy)";
    out.at_horizon = out.stationary = collect(p, {});
    return out;
  }
  const Eigen::Vector3d start(s.scene.momentum.data());
  std::vector<found_average> after, late;
  for (const char* name : at_horizon) {
    const auto f = *named_observable(name, p);
    after.emplace_back(name, expectation(p, f, start, s.scene.horizon, accuracy * size_on_sphere(f, p.radius)));
    if (!after.back().second.converged()) out.no_horizon = after.back().second.reason;
  }
  const auto law = true_law(s);
  out.no_law = law.reason;
  if (law.density && law.reason.empty())
    for (const char* name : in_the_long_run) late.emplace_back(name, mean(p, law, *named_observable(name, p)));
  out.at_horizon = collect(p, after);
  out.stationary = collect(p, late);
  if (out.at_horizon.count() > 0) out.no_horizon.clear();
  if (out.stationary.count() > 0) out.no_law.clear();
  return out;
}

}  // namespace polhode
