#include "experiments/bias_reference.hpp"

#include <algorithm>

namespace polhode {

law_observables bias_observables(const subject& s) {
  const auto all = every_observable(s);
  const auto energy = *named_observable("energy", s.scene.inertia);
  law_observables out{
      {"energy", "energy^2"}, {energy, [energy](const Eigen::Vector3d& pi) { return energy(pi) * energy(pi); }}, {}};
  for (std::size_t i = 0; i < all.names.size(); ++i) {
    if (all.names[i] == "energy" || all.names[i] == "casimir") continue;
    out.names.push_back(all.names[i]);
    out.functions.push_back(all.functions[i]);
  }
  const double radius = sphere_problem_of(s)->radius;
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

}  // namespace polhode
