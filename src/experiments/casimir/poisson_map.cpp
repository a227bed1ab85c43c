// SPDX-License-Identifier: Apache-2.0
#include "experiments/casimir/poisson_map.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <polhode/noise/normal.hpp>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/levels.hpp"
#include "problem/vectors.hpp"

namespace polhode {
namespace {

constexpr int levels = 10;                // dt times the fastest rate from 1/2, halved
constexpr double bound = 1e-12;           // relative; a step's rounding leaves some 1e-15
constexpr double fit_floor = 1e-13;       // of the order of the defect
constexpr int halvings_to_first = 1;      // of 1/rate
constexpr std::uint64_t same_states = 1;  // whatever the seed of the run: nothing is sampled here

std::vector<double> states_about(const subject& s) {
  const auto n = s.scene.momentum.size();
  const double size = length(s.scene.momentum) / std::sqrt(static_cast<double>(n));
  std::vector<double> out(n * block_lanes);
  for (std::size_t lane = 0; lane < block_lanes; ++lane)
    for (std::size_t k = 0; k < n; ++k) {
      const auto z = normals<2>({same_states, noise_kind::initial_state, lane, k / 2});
      out[k * block_lanes + lane] = size * z[static_cast<int>(k % 2)];
    }
  return out;
}

/// The end points and the Jacobians of one step, [column][component][lane].
struct stepped {
  std::vector<double> end, jacobian;
};

stepped step_of(const tangent_kernel& kernel, const std::vector<double>& start, std::size_t n) {
  stepped out{start, std::vector<double>(n * start.size())};
  for (std::size_t column = 0; column < n; column += tangent_vectors) {
    std::vector<double> tangents(tangent_vectors * start.size(), 0.0);
    for (std::size_t t = 0; t < tangent_vectors && column + t < n; ++t)
      std::fill_n(tangents.begin() + static_cast<std::ptrdiff_t>(t * start.size() + (column + t) * block_lanes),
                  block_lanes, 1.0);
    out.end = start;
    kernel.advance(out.end, tangents, silence(1));
    const auto wanted = std::min<std::size_t>(tangent_vectors, n - column) * start.size();
    std::copy_n(tangents.begin(), wanted, out.jacobian.begin() + static_cast<std::ptrdiff_t>(column * start.size()));
  }
  return out;
}

Eigen::MatrixXd bracket_at(const model& m, const std::vector<double>& mu) {
  const auto n = static_cast<Eigen::Index>(mu.size());
  Eigen::MatrixXd out(n, n);
  std::vector<double> unit(mu.size(), 0.0), column(mu.size());
  for (Eigen::Index k = 0; k < n; ++k) {
    unit[static_cast<std::size_t>(k)] = 1;
    m.coadjoint(unit, mu, column);
    unit[static_cast<std::size_t>(k)] = 0;
    out.col(k) = Eigen::Map<const Eigen::VectorXd>(column.data(), n);
  }
  return out;
}

report::verdict judge_kept(std::span<const double> defects) {
  const bool finite = std::ranges::all_of(defects, [](double d) { return std::isfinite(d); });
  const double worst = finite ? std::ranges::max(defects) : std::numeric_limits<double>::quiet_NaN();
  return judge_distance({worst, worst, worst}, bound,
                        finite ? fmt::format("|J B J^T - B| / |B| is at most {:.1e} over {} step sizes and {} states, "
                                             "bound {:g}",
                                             worst, defects.size(), block_lanes, bound)
                               : "a step is not finite: its equation was not solved");
}

/// Of a scheme that does not claim it.
report::verdict judge_defects(std::span<const double> defects, const std::optional<order_fit>& fit, double expected) {
  auto kept = judge_kept(defects);
  if (kept.kind != report::verdict_kind::holds) return judge_order(expected, fit, true);
  kept.reason = "a Poisson map on this scene, though none in general: " + kept.reason;
  return kept;
}

}  // namespace

double poisson_defect(const subject& s, const scheme_entry& scheme, double dt) {
  const auto n = s.scene.momentum.size();
  const auto start = states_about(s);
  const auto after = step_of(*scheme.tangent(dt), start, n);
  double worst = 0;
  for (int lane = 0; lane < block_lanes; ++lane) {
    const auto dimension = static_cast<int>(n);
    const auto before = bracket_at(*s.model, lane_of(start, lane, dimension));
    const auto at_end = bracket_at(*s.model, lane_of(after.end, lane, dimension));
    Eigen::MatrixXd jacobian(before.rows(), before.cols());
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        jacobian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
            after.jacobian[(j * n + i) * block_lanes + static_cast<std::size_t>(lane)];
    const double defect = (jacobian * before * jacobian.transpose() - at_end).norm() / at_end.norm();
    if (std::isnan(defect) || defect > worst) worst = defect;
  }
  return worst;
}

void report_poisson_map(const context& c, recorder& record) {
  const auto s = c.subject.without_noise().without_dissipation();
  const auto& scheme = *std::ranges::find(s.schemes, record.scheme(), [](const auto& e) { return e.info.name; });
  curve defect{{"Poisson defect", "bracket", "relative", "exact"}};
  std::vector<double> dt, defects;
  for (int l = 0; l < levels; ++l) {
    dt.push_back(std::exp2(-l - halvings_to_first) / fastest_rate(s));
    defects.push_back(poisson_defect(s, scheme, dt.back()));
    defect.add(dt.back(), defects.back());
  }
  const auto fit = fit_order(dt, defects, fit_floor);
  const auto written = record.series(defect, fit);
  if (scheme.info.poisson)
    record.verdict("Poisson map without noise and dissipation", judge_kept(defects), {written});
  else
    record.verdict("order of the Poisson defect", judge_defects(defects, fit, scheme.info.deterministic_order + 1),
                   {written});
}

}  // namespace polhode
