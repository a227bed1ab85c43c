#include "references/observables.hpp"

#include <fmt/format.h>

#include <cmath>

namespace polhode {
namespace {

constexpr int degree = 8;
constexpr double least = 1e-290;

}  // namespace

std::optional<sphere_function> named_observable(std::string_view name, const std::array<double, 3>& inertia) {
  using pi_type = const Eigen::Vector3d&;
  if (name == "energy")
    return [i = Eigen::Array3d(inertia.data())](pi_type pi) { return 0.5 * (pi.array().square() / i).sum(); };
  if (name == "casimir") return [](pi_type pi) { return 0.5 * pi.squaredNorm(); };
  if (name == "exp(pi3)") return [](pi_type pi) { return std::exp(pi[2]); };
  for (int k = 0; k < 3; ++k) {
    if (name == fmt::format("pi{}", k + 1)) return [k](pi_type pi) { return pi[k]; };
    if (name == fmt::format("pi{}^2", k + 1)) return [k](pi_type pi) { return pi[k] * pi[k]; };
  }
  return std::nullopt;
}

std::optional<double> unit_of(const sphere_problem& problem, const sphere_function& f) {
  const Eigen::VectorXd c =
      harmonic_coefficients([&](const Eigen::Vector3d& x) { return f(problem.radius * x); }, degree);
  const double largest = c.cwiseAbs().maxCoeff();
  if (!c.allFinite() || largest < least) return std::nullopt;
  return std::exp2(std::ilogb(largest));
}

}  // namespace polhode
