// SPDX-License-Identifier: Apache-2.0
// Densities to look at: the random measure of one noise path at four times, and the true stationary law.
//
// Of no scheme: the path is that of the Wong-Zakai equation (references/wong_zakai_equation.hpp).
#include <fmt/format.h>

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <numbers>

#include "ensemble/observing/sphere_bins.hpp"
#include "experiments/attractor/attractor.hpp"
#include "sphere/harmonics/harmonics.hpp"

namespace polhode {
namespace {

constexpr int longitudes = 128, heights = 64;
constexpr std::array shown_at{0.5, 1.0, 2.0, 4.0};  // in the time in which the area of a set shrinks by e

/// Three digits: it is looked at, and kept in a text.
double rounded(double x) {
  if (!(x > 0)) return 0;
  const double unit = std::pow(10, std::floor(std::log10(x)) - 2);
  return std::stod(fmt::format("{:.3g}", unit * std::round(x / unit)));
}

report::density relative(const std::string& name, std::optional<double> time, const std::vector<double>& values) {
  report::density d{"attractor", "", name, time, longitudes, heights, {}};
  for (const double x : values) d.values.push_back(rounded(x));
  return d;
}

/// Counts in bins of the files merged into those of the report.
std::vector<double> merged(const std::vector<std::uint32_t>& counts, double bodies) {
  constexpr int wide = longitude_bins::longitudes / longitudes, high = longitude_bins::heights / heights;
  std::vector<double> out(std::size_t{longitudes} * heights);
  for (int row = 0; row < longitude_bins::heights; ++row)
    for (int column = 0; column < longitude_bins::longitudes; ++column)
      out[static_cast<std::size_t>(row / high * longitudes + column / wide)] +=
          counts[static_cast<std::size_t>(row * longitude_bins::longitudes + column)];
  for (double& x : out) x *= longitudes * heights / bodies;
  return out;
}

std::vector<double> law_in_bins(const Eigen::VectorXd& density) {
  const int degree = static_cast<int>(std::lround(std::sqrt(static_cast<double>(density.size())))) - 1;
  points_on_sphere centres(longitudes * heights, 3);
  for (int row = 0; row < heights; ++row)
    for (int column = 0; column < longitudes; ++column) {
      const double z = 2 * (row + 0.5) / heights - 1, r = std::sqrt(1 - z * z);
      const double longitude = std::numbers::pi * (2 * (column + 0.5) / longitudes - 1);
      centres.row(row * longitudes + column) << r * std::cos(longitude), r * std::sin(longitude), z;
    }
  const Eigen::VectorXd values = 4 * std::numbers::pi * (harmonics(centres, degree) * density);
  return {values.begin(), values.end()};
}

}  // namespace

void report_snapshots(const context& c, const snapshots& of, noise_log& log, report::results& out) {
  auto p = common_noise_plan(c);
  p.start = of.start;
  p.pictured = of.pictured;
  p.bodies = by_effort(c.effort, 1 << 16, 1 << 18, 1 << 19);
  for (const double time : shown_at)
    p.snapshots.push_back(std::max<std::int64_t>(1, std::llround(time * of.unit / of.dt)));
  p.steps = p.snapshots.back();
  const auto part = log.open({"densities"}, 1);
  p.hear = [&](const increment_view& v) { log.add_path(0, v, of.dt, part); };
  const auto run = simulate_ensemble(*c.subject.model, *c.subject.model->reference(of.dt), p, c.progress);
  for (std::size_t i = 0; i < p.snapshots.size(); ++i) {
    const double time = static_cast<double>(p.snapshots[i]) * of.dt;
    out.densities.push_back(relative(fmt::format("{}, t = {:.4g}", of.name, time), time,
                                     merged(run.snapshots[i].counts, static_cast<double>(p.bodies))));
  }
}

void report_densities(const context& c, const attractor_frame& f, noise_log& log, report::results& out) {
  report_snapshots(c, {"one noise path", -1 / f.exponents.sum, f.dt}, log, out);
  out.densities.push_back(relative("stationary law", {}, law_in_bins(*f.law.density)));
}

}  // namespace polhode
