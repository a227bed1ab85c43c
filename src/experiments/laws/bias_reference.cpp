// SPDX-License-Identifier: Apache-2.0
#include "experiments/laws/bias_reference.hpp"
#include "sphere/harmonics/harmonics.hpp"

#include <algorithm>

namespace polhode {

law_observables bias_observables(const subject& s) {
  const auto all = every_observable(s);
  const auto& problem = *s.sphere();
  const auto energy = *named_observable("energy", problem);
  law_observables out{
      {"energy", "energy^2"}, {energy, [energy](const Eigen::Vector3d& pi) { return energy(pi) * energy(pi); }}, {}};
  for (std::size_t i = 0; i < all.names.size(); ++i) {
    if (all.names[i] == "energy" || all.names[i] == "casimir") continue;
    out.names.push_back(all.names[i]);
    out.functions.push_back(all.functions[i]);
  }
  const double radius = problem.radius;
  out.size.resize(std::ssize(out.names));
  std::ranges::transform(out.functions, out.size.begin(), [&](const auto& f) { return size_on_sphere(f, radius); });
  return out;
}

Eigen::MatrixXd coefficients_of(const law_observables& all, double radius, int degree) {
  Eigen::MatrixXd out(harmonic_count(degree), all.count());
  for (Eigen::Index i = 0; i < all.count(); ++i)
    out.col(i) = harmonic_coefficients(
        [&f = all.functions[static_cast<std::size_t>(i)], radius](const Eigen::Vector3d& x) { return f(radius * x); },
        degree);
  return out;
}

Eigen::MatrixXd coefficients_on(const shell_basis& basis, const law_observables& all) {
  Eigen::MatrixXd out(basis.size(), all.count());
  for (Eigen::Index i = 0; i < all.count(); ++i)
    out.col(i) = basis.coefficients(all.functions[static_cast<std::size_t>(i)]);
  return out;
}

transfer_answer bias_reference::of(const subject& s, const scheme_entry& e, double dt, std::int64_t steps) const {
  auto found = refine(s, e, dt, steps, question);
  const auto n = std::ssize(columns);
  if (found.error.size() > n && found.by_basis.size() > 0)
    found.uncertainty.head(n) += found.error.tail(n) - found.by_basis.head(n);
  found.error.conservativeResize(n);
  found.uncertainty.conservativeResize(n);
  found.uncertainty += uncertainty;
  return found;
}

Eigen::VectorXd bias_reference::change_by_far_noise(const subject& s, const scheme_entry& e, double dt,
                                                    std::int64_t steps) const {
  return polhode::change_by_far_noise(s, e, dt, steps, question.ask).head(std::ssize(columns));
}

}  // namespace polhode
