// SPDX-License-Identifier: Apache-2.0
// MicroMagnetic.jl draws the law of m_z of 27,000 spins with an easy axis over the exact one.
//
//   P(m) = exp(-chi (1 - m^2)) / Z on [-1, 1],  Z = 2 D(sqrt chi) / sqrt chi,  chi = K V / (k_B T)
#include <fmt/format.h>
#include <gsl/gsl_sf_dawson.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <numbers>

#include "reproduction/cases.hpp"
#include "reproduction/judged.hpp"
#include "reproduction/scenes.hpp"
#include "run/reference.hpp"
#include "transfer/transfer_refine.hpp"

namespace polhode {
namespace {

constexpr double chi = 7.2e5 * 2.8e-26 / (1.3806505e-23 * 300);  // k_B as in their src/const.jl
constexpr double uniaxial_dt = 0.01, spins = 27'000, deviations = 1.96;
constexpr int direction_bins = 20;
using gauss = boost::math::quadrature::gauss<double, 30>;

double published_density(double m) {
  const double z = 2 * gsl_sf_dawson(std::sqrt(chi)) / std::sqrt(chi);
  return std::exp(-chi * (1 - m * m)) / z;
}

double edge(int bin) { return -1 + 2.0 * bin / direction_bins; }

Eigen::VectorXd published_shares() {
  Eigen::VectorXd out(direction_bins);
  for (int i = 0; i < direction_bins; ++i) out[i] = gauss::integrate(published_density, edge(i), edge(i + 1));
  return out;
}

double published_square() {
  return gauss::integrate([](double m) { return m * m * published_density(m); }, -1.0, 1.0);
}

/// The integral of each harmonic over each bin of m_z: harmonics that vary with the longitude have none.
Eigen::MatrixXd integrals(const shell_basis& basis) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(basis.size(), direction_bins);
  for (int l = 0; l <= basis.degree(); ++l) {
    const auto along = [l](double m) {
      return harmonics_at({std::sqrt(1 - m * m), 0, m}, l)[harmonic_index(l, 0)] * 2 * std::numbers::pi;
    };
    for (int i = 0; i < direction_bins; ++i)
      out(harmonic_index(l, 0), i) = gauss::integrate(along, edge(i), edge(i + 1));
  }
  return out;
}

/// Shares of the bins and E[m_z^2] under the law that the scheme keeps.
Eigen::VectorXd shares_and_square(const transfer_operator& op) {
  const Eigen::RowVectorXd law = op.stationary_law();
  Eigen::VectorXd out(direction_bins + 1);
  out.head(direction_bins) = (law * integrals(op.basis)).transpose();
  out[direction_bins] = law.dot(op.basis.coefficients([](const Eigen::Vector3d& s) { return s[2] * s[2]; }));
  return out;
}

/// 95 % of what that many independent spins scatter by.
double scatter(double variance) { return deviations * std::sqrt(variance / spins); }

void compare_directions(const subject& bound, const std::string& name, report::reproduction& out) {
  Eigen::VectorXd exact(direction_bins + 1);
  exact << published_shares(), published_square();
  const auto answer = refine(bound, scheme_of(bound, name), uniaxial_dt, 1,
                             {shares_and_square, {exact, Eigen::VectorXd::Ones(direction_bins + 1), 1e-3}});
  const Eigen::ArrayXd p = exact.head(direction_bins).array();
  const Eigen::ArrayXd allowed = deviations * (p * (1 - p) / spins).sqrt();
  const Eigen::ArrayXd off = answer.error.head(direction_bins).array().abs() / allowed,
                       unsure = answer.uncertainty.head(direction_bins).array() / allowed;
  Eigen::Index worst = 0;
  off.maxCoeff(&worst);
  out.numbers.push_back(compared_at_most(
      fmt::format("{}, dt = {}: largest |P - formula| of 20 bins, in 95 % scatters of 27,000 spins", name, uniaxial_dt),
      1, within(off[worst], unsure[worst]),
      fmt::format("in the bin from m_z = {:.1f}; nothing sampled", edge(int(worst)))));
  const double fourth = gauss::integrate([](double m) { return m * m * m * m * published_density(m); }, -1.0, 1.0);
  const double square = exact[direction_bins];
  out.numbers.push_back(compared(fmt::format("{}, dt = {}: E[m_z^2]", name, uniaxial_dt), square,
                                 scatter(fourth - square * square),
                                 within(square + answer.error[direction_bins], answer.uncertainty[direction_bins]),
                                 "published with the scatter of 27,000 spins"));
  if (!out.curves.empty()) return;
  report::reproduced_curve curve{"Law of m_z in bins of 0.1",
                                 "m_z",
                                 "ln P",
                                 "formula (MicroMagnetic.jl)",
                                 fmt::format("{}, dt = {}", name, uniaxial_dt),
                                 false,
                                 {}};
  for (int i = 0; i < direction_bins; ++i)
    curve.points.push_back({edge(i) + 1.0 / direction_bins, std::log(exact[i] * direction_bins / 2),
                            std::log(std::max(1e-300, (exact[i] + answer.error[i]) * direction_bins / 2))});
  out.curves.push_back(std::move(curve));
}

}  // namespace

report::reproduction uniaxial_spin(const reproduce_options&) {
  report::reproduction out;
  out.source =
      "MicroMagnetic.jl, docs/tutorials/atomistic/sllg.jl (tutorial Stochastic LLG, figure P_mz) and src/const.jl of "
      "commit 5bad73d: "
      "K = 7.2e5 J/m^3, V = 2.8e-26 m^3, T = 300 K, k_B = 1.3806505e-23 J/K, 30 x 30 x 30 spins, alpha = 0.1";
  out.scene = fmt::format(
      "name = \"uniaxial_spin\"\nsystem = \"spin\"\nanisotropy = {}   # K V / (k_B T)\nfield = [0.0, 0.0, "
      "0.0]\ndamping "
      "= 0.1\ntemperature = 1.0\nmomentum = [0.6, 0.0, 0.8]\nhorizon = 1.0\n",
      chi);
  out.notes = {
      "Energies are in units of k_B T, times in mu_s / (gamma k_B T) = 5.45e-12 s: their step of 1e-15 s is 1.8e-4 "
      "here.",
      "Published are the formula and a plot of log P in bins of 0.1, no table: a bin agrees where it lies within what "
      "their 27,000 spins scatter by.",
      "With k_B = 1.380649e-23 J/K, chi is 4.867276891850 and E[m_z^2] is 0.757367637896.",
      "Ours is the law that a scheme's transfer operator leaves as it is, and the exact one: nothing is sampled."};
  const auto s = scene_of(out.scene);
  const auto exact = reference(s, {"gibbs", "pi3^2", {}, 0});
  out.numbers.push_back(compared("E[m_z^2], exact", published_square(), 1e-10, within(exact.value, exact.uncertainty),
                                 "published: the mean under their formula; ours: " + exact.method));
  const auto bound = bind_scene(s);
  for (const auto* name : {"heun_projected", "implicit_midpoint", "lie_heun"}) compare_directions(bound, name, out);
  return out;
}

}  // namespace polhode
