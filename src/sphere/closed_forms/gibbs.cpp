// SPDX-License-Identifier: Apache-2.0
#include "sphere/closed_forms/gibbs.hpp"

#include <gsl/gsl_interp.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <cmath>
#include <utility>

#include "sphere/closed_forms/gibbs_moments.hpp"
#include "sphere/equilibria.hpp"
#include "sphere/harmonics/harmonics.hpp"

namespace polhode {
namespace {

constexpr int panels = 600;
constexpr double negligible = 50;  // exp(-50) of the mass is nothing

// Clusters points at both ends like s^4, which takes the edge off a logarithm or an inverse square root there.
double smoothstep(double s) { return s * s * (3 - 2 * s); }
double smoothstep_inverse(double y) { return 0.5 - std::sin(std::asin(1 - 2 * y) / 3); }
double clustered(double s) { return smoothstep(smoothstep(s)); }
double clustered_slope(double s) { return 36 * smoothstep(s) * smoothstep(1 - s) * s * (1 - s); }
double clustered_inverse(double y) { return smoothstep_inverse(smoothstep_inverse(y)); }

/// Of the free motion at energy h, I[0] <= I[1] <= I[2]. from: distances 2 h I_k - c^2 without sign, computed by the
/// caller so that they do not cancel.
double period(const std::array<double, 3>& i, const std::array<double, 3>& from, bool round_last) {
  const int round = round_last ? 2 : 0, other = round_last ? 0 : 2;
  const double near = std::fabs(i[round] - i[1]), far = std::fabs(i[1] - i[other]);
  const double m = std::clamp(far * from[round] / (near * from[other]), 0.0, 1 - 1e-16);
  return 4 * boost::math::ellint_1(std::sqrt(m)) * std::sqrt(i[0] * i[1] * i[2] / (near * from[other]));
}

/// Points of the sphere by their energy above the least, with their probability.
struct weighed_points {
  std::vector<std::pair<double, double>> points;
  double mean = 0, variance = 0;  ///< of that energy
  Eigen::Vector3d square = Eigen::Vector3d::Zero();
};

weighed_points weighed(const sphere_problem& p, double least, int degree) {
  const double beta = 2 * p.damping / p.covariance(0, 0);
  const auto rule = sphere_quadrature(degree);
  weighed_points out;
  double total = 0;
  for (Eigen::Index i = 0; i < rule.weights.size(); ++i) {
    const Eigen::Vector3d pi = p.radius * rule.points.row(i).transpose();
    const double above = std::max(0.0, p.energy(pi) - least), mass = rule.weights[i] * std::exp(-beta * above);
    out.points.emplace_back(above, mass);
    out.square += mass * pi.cwiseAbs2();
    out.mean += mass * above;
    total += mass;
  }
  out.square /= total;
  out.mean /= total;
  for (auto& [above, mass] : out.points) out.variance += (mass /= total) * std::pow(above - out.mean, 2);
  std::ranges::sort(out.points);
  return out;
}

}  // namespace

struct gibbs_law::piece {
  double low = 0, high = 0;     // energies
  std::vector<double> s, mass;  // cumulative probability at s, h = low + (high - low) clustered(s)
};

gibbs_law::~gibbs_law() = default;
gibbs_law::gibbs_law(gibbs_law&&) noexcept = default;

gibbs_law::gibbs_law(const std::array<double, 3>& inertia, double c, double beta) {
  std::array<int, 3> order{0, 1, 2};
  std::ranges::sort(order, [&](int a, int b) { return inertia[a] < inertia[b]; });
  std::array<double, 3> i{};
  for (int k = 0; k < 3; ++k) {
    i[k] = inertia[order[k]];
    critical_[k] = c * c / (2 * i[k]);
  }
  least_ = critical_[2];
  greatest_ = critical_[0];
  const auto above_least = [&](int k) { return c * c * (i[2] - i[k]) / (2 * i[k] * i[2]); };  // does not cancel
  const auto moments = bingham(above_least(0), above_least(1), beta);
  excess_ = moments.mean;
  variance_ = moments.variance;
  relative_uncertainty_ = moments.relative_uncertainty;
  for (int k = 0; k < 3; ++k) squares_[order[k]] = c * c * moments.square[k];
  add_piece(i, beta, critical_[2], critical_[1], true);
  add_piece(i, beta, critical_[1], critical_[0], false);
  const double total = pieces_.empty() ? 1 : pieces_.back().mass.back();
  for (piece& p : pieces_)
    for (double& mass : p.mass) mass /= total;
}

void gibbs_law::add_piece(const std::array<double, 3>& i, double beta, double low, double high, bool round_last) {
  const double faded = least_ + negligible / beta;  // infinite for beta = 0
  if (!(high > low) || low > faded) return;
  high = std::min(high, std::max(faded, low + negligible / beta));
  const double before = pieces_.empty() ? 0 : pieces_.back().mass.back();
  piece p{low, high, {0}, {before}};
  const auto density = [&](double s) {
    const double above = (high - low) * clustered(s), below = (high - low) * clustered(1 - s);
    std::array<double, 3> from{};
    for (int k = 0; k < 3; ++k)
      from[k] =
          2 * i[k] * std::fabs(critical_[k] <= low ? above + (low - critical_[k]) : below + (critical_[k] - high));
    const double boltzmann = std::exp(-beta * (above + (low - least_)));
    return boltzmann * period(i, from, round_last) * (high - low) * clustered_slope(s);
  };
  for (int n = 1; n <= panels; ++n) {
    p.s.push_back(n / double(panels));
    const double mass = boost::math::quadrature::gauss<double, 10>::integrate(density, p.s[n - 1], p.s[n]);
    p.mass.push_back(p.mass.back() + mass);
  }
  pieces_.push_back(std::move(p));
}

gibbs_law gibbs_law::by_quadrature(const sphere_problem& p) {
  constexpr int degree = 800;
  const auto extremes = equilibria(p);
  const auto coarse = weighed(p, extremes.front().energy, degree / 2),
             fine = weighed(p, extremes.front().energy, degree);
  gibbs_law out;
  out.least_ = extremes.front().energy;
  out.greatest_ = extremes.back().energy;
  out.excess_ = fine.mean;
  out.variance_ = fine.variance;
  for (int k = 0; k < 3; ++k) out.squares_[static_cast<std::size_t>(k)] = fine.square[k];
  const double change = std::max(std::fabs(fine.mean / coarse.mean - 1),
                                 (fine.square.array() / coarse.square.array() - 1).abs().maxCoeff());
  out.relative_uncertainty_ = std::max(change, 1e-15);
  piece all{out.least_, out.greatest_, {0}, {0}};
  auto next = fine.points.begin();
  for (int n = 1; n <= panels; ++n) {
    const double s = n / double(panels), above = (out.greatest_ - out.least_) * clustered(s);
    double mass = all.mass.back();
    for (; next != fine.points.end() && (next->first <= above || n == panels); ++next) mass += next->second;
    all.s.push_back(s);
    all.mass.push_back(mass);
  }
  out.pieces_.push_back(std::move(all));
  return out;
}

double gibbs_law::energy_cdf(double h) const {
  if (h <= least_) return 0;
  for (const piece& p : pieces_) {
    if (h >= p.high) continue;
    const double s = clustered_inverse((h - p.low) / (p.high - p.low));
    const std::size_t right =
        std::clamp<std::size_t>(gsl_interp_bsearch(p.s.data(), s, 0, p.s.size() - 1) + 1, 1, p.s.size() - 1);
    const double share = (s - p.s[right - 1]) / (p.s[right] - p.s[right - 1]);
    return std::lerp(p.mass[right - 1], p.mass[right], share);
  }
  return 1;
}

}  // namespace polhode
