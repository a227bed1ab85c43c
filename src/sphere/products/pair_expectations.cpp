// SPDX-License-Identifier: Apache-2.0
#include "sphere/products/pair_expectations.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "algebra/exponential_action.hpp"
#include "references/odeint.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/observables.hpp"
#include "sphere/products/pair_generator.hpp"

namespace polhode {
namespace {

constexpr std::array degrees{4, 6, 8, 10, 12, 14, 16, 20, most_pair_degree};
constexpr double affordable = 1e10;   // multiplications
constexpr double most_turns = 1e7;    // seconds
constexpr double first_piece = 0.37;  // of the time: no divisor of the solver's first step

using momenta = Eigen::Matrix<double, 6, 1>;

/// As if the other were a field: the degree at which agreement of degrees begins to tell.
double needed_degree_of(const sphere_pair& p) {
  double needed = 0;
  for (const int i : {0, 1}) {
    auto site = p.sites[static_cast<std::size_t>(i)];
    const double field = site.field.norm() + std::fabs(p.exchange) * p.sites[static_cast<std::size_t>(1 - i)].radius;
    site.field = {0, 0, field};
    needed = std::max(needed, needed_degree(site));
  }
  return needed;
}

momenta solved(const sphere_pair& p, const momenta& start, double time) {
  const auto drift = [&](std::span<const double> mu, std::span<double> out) {
    const Eigen::Map<const Eigen::Matrix<double, 3, 2>> pi(mu.data());
    for (int i = 0; i < 2; ++i) {
      const auto& site = p.sites[static_cast<std::size_t>(i)];
      const Eigen::Vector3d own = pi.col(i), rate = site.rate(own) + p.exchange * pi.col(1 - i);
      Eigen::Map<Eigen::Vector3d>(out.data() + 3 * i) = own.cross(rate + site.damping * own.cross(rate));
    }
  };
  return momenta(solve_drift(drift, std::span(start.data(), 6), time).data());
}

/// f without noise; uncertain by its distance from the same path in two pieces.
reference_value on_the_path(const sphere_pair& p, const site_observable& f, const momenta& start, double time) {
  double turning = 0;
  for (const auto& site : p.sites)
    turning += (greatest_rate_on(site) + std::fabs(p.exchange) * start.norm()) * (1 + site.damping * site.radius);
  if (!(time * turning <= most_turns)) return {.reason = "no noise, and too many turns to follow"};
  const auto value = [&](const momenta& mu) {
    return f.energy ? p.energy(mu.head<3>(), mu.tail<3>()) : std::pow(mu[3 * f.site + f.axis], f.power);
  };
  const double one = value(solved(p, start, time));
  const double two = value(solved(p, solved(p, start, first_piece * time), (1 - first_piece) * time));
  if (!std::isfinite(one)) return {.reason = "no noise, and the solver of the path broke down"};
  return {.value = one,
          .uncertainty = std::max(std::fabs(one - two), rounding_of_sums * std::max(1.0, std::fabs(one)))};
}

}  // namespace

pair_expectations::pair_expectations(const sphere_pair& pair, const momenta& start, double time, int most_degree)
    : pair_(pair), start_(start), time_(time), most_degree_(most_degree) {}

pair_expectations::projection& pair_expectations::at(int degree) {
  const auto known = known_.find(degree);
  if (known != known_.end()) return known->second;
  return known_
      .emplace(degree,
               projection{tall_backward_operator(pair_, degree),
                          pair_harmonics_at(start_.head<3>().normalized(), start_.tail<3>().normalized(), degree),
                          {}})
      .first->second;
}

const Eigen::VectorXd& pair_expectations::law_at(int degree) {
  auto& p = at(degree);
  if (std::exchange(p.law_known, true)) return p.law;
  const sparse_matrix forward = p.tall.topRows(p.tall.cols()).transpose();
  if (exponential_action_products(forward, time_) * static_cast<double>(forward.nonZeros()) <= affordable)
    p.law = exponential_action(forward, time_, p.start);
  return p.law;
}

/// Of f over a unit of its own, and in its own again.
reference_value pair_expectations::raised(const site_observable& f, double share, int wanted,
                                          const value_at_degree& value_at) const {
  const Eigen::VectorXd exact = pair_coefficients(pair_, f, degrees.front());
  if (exact.isZero(0)) return {.value = 0};
  const auto unit = unit_of(exact);
  if (!unit) return {.reason = leaves_double_precision};
  const double size = (exact / *unit).norm() / unit_of_pair_mean;
  const auto most = std::ranges::upper_bound(degrees, most_degree_);
  const std::vector<int> automatic(degrees.begin(), most), chosen{wanted};
  auto found = raise_degree(
      wanted > 0 ? chosen : automatic, accuracy{.absolute = share * size, .size = size, .unit = *unit},
      needed_degree_of(pair_),
      [&](int degree) { return value_at(degree, pair_coefficients(pair_, f, degree) / *unit); }, wanted);
  if (found.value) *found.value *= *unit;
  found.uncertainty *= *unit;
  return found;
}

reference_value pair_expectations::of(const site_observable& f, double share, int wanted) {
  if (!pair_.has_noise()) return on_the_path(pair_, f, start_, time_);
  bool relaxed = false;
  auto found = raised(f, share, wanted, [&](int degree, const Eigen::VectorXd& c) -> std::optional<projected_value> {
    const auto& p = at(degree);
    const suprema_of_basis suprema{[](const Eigen::VectorXd& g) { return pair_supremum(g); },
                                   [=](const Eigen::VectorXd& g) { return pair_supremum(g, degree + 1); },
                                   unit_of_pair_mean};
    const auto value = propagated(p.tall, c, p.start, time_, suprema);
    if (!value) return {};
    relaxed = value->relaxed;
    return value->found;
  });
  found.relaxed = relaxed;
  return found;
}

reference_value pair_expectations::agreed(const site_observable& f, double share) {
  if (!pair_.has_noise()) return on_the_path(pair_, f, start_, time_);
  return raised(f, share, 0, [&](int degree, const Eigen::VectorXd& c) -> std::optional<projected_value> {
    const auto& law = law_at(degree);
    if (law.size() == 0) return {};
    return projected_value{c.dot(law), rounding_of_sums * c.norm() * law.norm()};
  });
}

}  // namespace polhode
