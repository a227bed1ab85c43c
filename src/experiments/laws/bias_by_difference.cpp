// SPDX-License-Identifier: Apache-2.0
#include <limits>
#include <map>
#include <memory>
#include <mutex>

#include "experiments/laws/bias_reference.hpp"
#include "experiments/laws/difference_bar.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/stationary.hpp"

namespace polhode {
namespace {

constexpr double usable_mean = 1e-5;    // of an observable's size
constexpr int sensitivity_degree = 40;  // at which the effects of noise and dissipation are told

/// The equation projected on harmonics up to each degree that is asked for.
class projected_equation {
 public:
  projected_equation(sphere_problem p, law_observables all) : problem_(std::move(p)), all_(std::move(all)) {}

  struct at_degree {
    Eigen::MatrixXd functions;
    projected_generator generator;
  };
  const at_degree& of(int degree) {
    const std::lock_guard lock(one_);
    auto& found = known_[degree];
    if (found.functions.size() == 0) {
      found.functions = coefficients_of(all_, problem_.radius, degree);
      found.generator = project_generator(backward_operator(problem_, degree), found.functions);
    }
    return found;
  }

 private:
  sphere_problem problem_;
  law_observables all_;
  std::mutex one_;
  std::map<int, at_degree> known_;
};

/// The differences, and behind them how far each is known.
Eigen::VectorXd differences(const transfer_operator& op, const projected_equation::at_degree& equation) {
  const Eigen::Index count = equation.functions.cols();
  if (equation.generator.law.size() == 0)
    return Eigen::VectorXd::Constant(2 * count, std::numeric_limits<double>::quiet_NaN());
  const Eigen::RowVectorXd law = op.stationary_law();
  Eigen::VectorXd out(2 * count);
  out << ((law - equation.generator.law) * equation.functions).transpose(),
      difference_bar(op.matrix, law, equation.generator, equation.functions);
  return out;
}

/// Why the mean of h is not known well enough to speak of a bias; empty: it is.
std::string unknown_mean(const sphere_problem& p, const stationary_law& law) {
  const auto energy = *named_observable("energy", p);
  const auto found = mean(p, law, energy);
  if (found.value && found.uncertainty <= usable_mean * size_on_sphere(energy, p.radius)) return "";
  return found.reason.empty() ? "the mean of h is not known well enough" : found.reason;
}

std::vector<error_column> difference_columns(const sphere_problem& p, const law_observables& all) {
  const Eigen::MatrixXd functions = coefficients_of(all, p.radius, sensitivity_degree);
  const auto means = [&](const sphere_problem& of) -> Eigen::RowVectorXd {
    const auto law = project_generator(backward_operator(of, sensitivity_degree), functions).law;
    return law.size() > 0 ? Eigen::RowVectorXd(law * functions) : Eigen::RowVectorXd::Zero(functions.cols());
  };
  const Eigen::RowVectorXd now = means(p), noise = means(with_more_noise(p, sensitivity_share)) - now,
                           dissipation = means(with_more_dissipation(p, sensitivity_share)) - now;
  std::vector<error_column> out;
  for (Eigen::Index i = 0; i < all.count(); ++i)
    out.push_back({"bias", all.names[static_cast<std::size_t>(i)], all.size[i], noise[i] / sensitivity_share,
                   dissipation[i] / sensitivity_share});
  return out;
}

}  // namespace

std::optional<bias_reference> bias_by_difference(const subject& s, const stationary_law& law, std::string& reason) {
  const auto p = *s.sphere();
  const auto all = bias_observables(s);
  reason = law.density ? unknown_mean(p, law) : law.reason;
  if (!reason.empty()) return std::nullopt;
  const auto n = all.count();
  bias_reference out;
  out.columns = difference_columns(p, all);
  out.question.ask = [equation = std::make_shared<projected_equation>(p, all)](const transfer_operator& op) {
    return differences(op, equation->of(op.basis.degree()));
  };
  out.question.target = {Eigen::VectorXd::Zero(2 * n), all.size.replicate(2, 1), bias_tolerance, n};
  out.uncertainty = Eigen::VectorXd::Zero(n);
  return out;
}

}  // namespace polhode
