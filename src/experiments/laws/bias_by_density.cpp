// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "experiments/laws/bias_reference.hpp"
#include "experiments/laws/true_law.hpp"

namespace polhode {
namespace {

constexpr double sensitivity_accuracy = 1e-8;  // of the density, in L2

/// The distance in L2 of two laws in harmonics; beyond its degree a law has none.
double distance(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const auto both = std::min(a.size(), b.size());
  return std::sqrt((a.head(both) - b.head(both)).squaredNorm() + a.tail(a.size() - both).squaredNorm() +
                   b.tail(b.size() - both).squaredNorm());
}

Eigen::VectorXd means_under(const law_observables& all, double radius, const Eigen::VectorXd& density) {
  const int degree = static_cast<int>(std::lround(std::sqrt(static_cast<double>(density.size())))) - 1;
  return coefficients_of(all, radius, degree).transpose() * density;
}

Eigen::VectorXd with_one_more(const Eigen::VectorXd& v, double last) {
  Eigen::VectorXd out(v.size() + 1);
  out << v, last;
  return out;
}

/// With what moves the means: difference quotients, no better than their share need be.
std::vector<error_column> density_columns(const subject& s, const law_observables& all, const Eigen::VectorXd& mean,
                                          double density) {
  const auto p = *s.sphere();
  const auto moved = [&](const sphere_problem& other) -> Eigen::VectorXd {
    const auto law = law_of(other, s.model->noise() == noise_class::isotropic, sensitivity_accuracy);
    if (!is_usable(law)) return Eigen::VectorXd::Zero(all.count());
    return (means_under(all, p.radius, *law.density) - mean) / sensitivity_share;
  };
  const Eigen::VectorXd noise = moved(with_more_noise(p, sensitivity_share)),
                        dissipation = moved(with_more_dissipation(p, sensitivity_share));
  std::vector<error_column> out;
  for (Eigen::Index i = 0; i < all.count(); ++i)
    out.push_back({"bias", all.names[static_cast<std::size_t>(i)], all.size[i], noise[i], dissipation[i]});
  out.push_back({.quantity = "distance", .observable = "density", .scale = density, .distance = true});
  return out;
}

}  // namespace

bias_reference bias_by_density(const subject& s, const stationary_law& law) {
  const auto all = bias_observables(s);
  const auto& density = *law.density;
  const Eigen::VectorXd mean = means_under(all, s.sphere()->radius, density);
  const Eigen::VectorXd scale = with_one_more(all.size, density.norm());
  return {density_columns(s, all, mean, density.norm()),
          {[density, all](const transfer_operator& op) {
             const Eigen::RowVectorXd own = op.stationary_law();
             return with_one_more((own * coefficients_on(op.basis, all)).transpose(),
                                  distance(own.transpose(), density));
           },
           {with_one_more(mean, 0), scale, bias_tolerance}},
          law.uncertainty / density.norm() * scale};
}

}  // namespace polhode
