// SPDX-License-Identifier: Apache-2.0
#include "systems/heavy_top/heavy_top_gibbs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "sphere/harmonics/harmonics.hpp"

namespace polhode {
namespace {

constexpr int first_degree = 32, most_degree = 1024;
constexpr double tolerance = 1e-12;  // of the size of what is averaged

/// The mean of an observable over Pi, at one Gamma.
using partial_mean = std::function<double(const Eigen::Vector3d& gamma)>;

double moment_of_inertia(const heavy_top_gibbs& law, const Eigen::Vector3d& gamma) {
  return gamma.dot(law.inertia.cwiseProduct(gamma));
}

partial_mean mean_of_momentum(const heavy_top_gibbs& law, int k) {
  return [=](const Eigen::Vector3d& gamma) {
    return law.along * law.inertia[k] * gamma[k] / moment_of_inertia(law, gamma);
  };
}

partial_mean mean_of_square(const heavy_top_gibbs& law, int k) {
  return [=](const Eigen::Vector3d& gamma) {
    const double i = law.inertia[k], across = i * gamma[k], total = moment_of_inertia(law, gamma);
    return (i - across * across / total) / law.beta + std::pow(law.along * across / total, 2);
  };
}

partial_mean observable_named(const heavy_top_gibbs& law, std::string_view name) {
  if (name == "energy")
    return [=](const Eigen::Vector3d& gamma) {
      return 1 / law.beta + law.along * law.along / (2 * moment_of_inertia(law, gamma)) + law.pull.dot(gamma);
    };
  for (int k = 0; k < 3; ++k) {
    if (name == fmt::format("pi{}", k + 1) || name == fmt::format("mu_{}", k + 1)) return mean_of_momentum(law, k);
    if (name == fmt::format("pi{}^2", k + 1)) return mean_of_square(law, k);
    if (name == fmt::format("gamma{}", k + 1) || name == fmt::format("mu_{}", k + 4))
      return [k](const Eigen::Vector3d& gamma) { return gamma[k]; };
    if (name == fmt::format("gamma{}^2", k + 1))
      return [k](const Eigen::Vector3d& gamma) { return gamma[k] * gamma[k]; };
  }
  return nullptr;
}

struct mean_and_size {
  double mean, size;  ///< of f and of |f|
};

mean_and_size average(const heavy_top_gibbs& law, const partial_mean& f, int degree) {
  const auto rule = sphere_quadrature(degree);
  Eigen::VectorXd exponent(rule.weights.size());
  for (Eigen::Index i = 0; i < exponent.size(); ++i) {
    const Eigen::Vector3d gamma = rule.points.row(i).transpose();
    const double total = moment_of_inertia(law, gamma);
    exponent[i] = -law.beta * (law.along * law.along / (2 * total) + law.pull.dot(gamma)) - 0.5 * std::log(total);
  }
  const Eigen::VectorXd mass = (exponent.array() - exponent.maxCoeff()).exp() * rule.weights.array();
  mean_and_size out{0, 0};
  for (Eigen::Index i = 0; i < mass.size(); ++i) {
    const double value = f(rule.points.row(i).transpose());
    out.mean += mass[i] * value;
    out.size += mass[i] * std::fabs(value);
  }
  return {out.mean / mass.sum(), out.size / mass.sum()};
}

}  // namespace

std::optional<reference_value> heavy_top_gibbs::mean(std::string_view observable) const {
  const auto f = observable_named(*this, observable);
  if (!f) return std::nullopt;
  auto before = average(*this, f, first_degree);
  for (int degree = 2 * first_degree;; degree *= 2) {
    const auto now = average(*this, f, degree);
    const double change = std::fabs(now.mean - before.mean), rounding = 1e-14 * now.size;
    const bool converged = change <= tolerance * now.size;
    if (converged || degree >= most_degree)
      return reference_value{.value = now.mean,
                             .uncertainty = std::max(change, rounding),
                             .reason = converged ? "" : "the law is too narrow for the quadrature over the sphere"};
    before = now;
  }
}

}  // namespace polhode
