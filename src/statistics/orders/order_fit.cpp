// SPDX-License-Identifier: Apache-2.0
#include "statistics/orders/order_fit.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>

#include "statistics/orders/level_choice.hpp"
#include "statistics/resample.hpp"
#include "statistics/resampled_means.hpp"

namespace polhode {
namespace {

order_fit result_of(const level_choice& c, const log_line& l, double low, double high, std::size_t count) {
  order_fit fit{l.slope, low, high, std::exp2(l.intercept), std::vector<bool>(count, false), c.rule, true, {}};
  for (const auto& kept : c.levels) fit.used[static_cast<std::size_t>(kept.index)] = true;
  return fit;
}

/// The levels that are finite and above the floor, without sampling error.
std::vector<log_level> finite_levels(std::span<const double> x, std::span<const double> value, double floor) {
  std::vector<log_level> levels;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::isfinite(value[i]) && value[i] > floor)
      levels.push_back({static_cast<int>(i), std::log2(x[i]), std::log2(value[i]), 0});
  return levels;
}

order_fit exact_fit(const level_choice& c, std::size_t count) {
  const auto line = line_through(c.levels);
  const double half = half_width_of_scatter(c.levels, line);
  auto fit = result_of(c, line, line.slope - half, line.slope + half, count);
  fit.asymptotic =
      std::fabs(off_the_others(c.levels)) <= off_the_line &&  // what scatters without sampling is curvature
      std::ranges::all_of(c.levels, [&](const auto& l) { return std::fabs(l.y - line.at(l.x)) <= off_the_line; });
  fit.finest.value = fit.finest.low = fit.finest.high = slope_at_the_finest(c.levels);
  return fit;
}

/// Of which the order of mean^power is asked, and the levels that take part.
struct moments {
  squared_errors values;
  double power = 1;
  level_choice chosen = {};
};

/// The levels whose mean is finite and above that, with its sampling error; of mean^power.
std::vector<log_level> levels_of_means(std::span<const double> x, const squared_errors& values, double power,
                                       double least_mean) {
  std::vector<log_level> levels;
  for (int i = 0; i < values.levels; ++i) {
    const auto at = level_mean(values, i);
    if (!std::isfinite(at.mean) || at.mean <= least_mean) continue;
    levels.push_back({i, std::log2(x[static_cast<std::size_t>(i)]), power * std::log2(at.mean),
                      std::max(1e-12, power * at.error / at.mean / std::log(2.0))});
  }
  return levels;
}

void choose_levels_of(std::span<const double> dt, double least_mean, moments& m) {
  auto levels = levels_of_means(dt, m.values, m.power, least_mean);
  const auto left_out = static_cast<std::size_t>(m.values.levels) - levels.size();
  m.chosen = choose_levels(std::move(levels), left_out);
  if (m.chosen.levels.size() < least_levels) m.chosen = {};
}

/// `resampled`: means of the replicates, [replicate][level that may take part]. Each chooses its own levels for its
/// slope, as the choice is part of what would come out otherwise.
order_fit resampled_fit(const moments& m, const Eigen::Ref<const Eigen::MatrixXd>& resampled) {
  const auto early = m.chosen.finest.size() - m.chosen.levels.size();
  std::vector<double> slopes, off, finest;
  auto levels = m.chosen.finest;
  for (Eigen::Index r = 0; r < resampled.rows(); ++r) {
    for (std::size_t k = 0; k < levels.size(); ++k)
      levels[k].y = m.power * std::log2(resampled(r, static_cast<Eigen::Index>(k)));
    slopes.push_back(line_through(asymptotic_part(levels)).slope);
    const auto same = std::span(levels).subspan(early);
    off.push_back(off_the_others(same));
    finest.push_back(slope_at_the_finest(same));
  }
  const auto [low, high] = bootstrap_interval(slopes, 0.95, m.values.paths);
  const auto [least, most] = bootstrap_interval(off, 0.95, m.values.paths);
  auto fit = result_of(m.chosen, line_through(m.chosen.levels), low, high, static_cast<std::size_t>(m.values.levels));
  fit.asymptotic = least <= off_the_line && most >= -off_the_line;
  const auto [slowest, fastest] = bootstrap_interval(finest, 0.95, m.values.paths);
  fit.finest = {slope_at_the_finest(m.chosen.levels), slowest, fastest};
  return fit;
}

std::vector<std::optional<order_fit>> resampled_fits(std::span<const moments> all, std::uint64_t seed) {
  Eigen::Index columns = 0;
  for (const auto& m : all) columns += static_cast<Eigen::Index>(m.chosen.finest.size());
  values_of_paths values(all.front().values.paths, columns);
  Eigen::Index next = 0;
  for (const auto& m : all)
    for (const auto& l : m.chosen.finest) values.col(next++) = matrix_of(m.values).col(l.index);
  const auto resampled = resampled_means(values, seed);
  std::vector<std::optional<order_fit>> out;
  next = 0;
  for (const auto& m : all) {
    const auto count = static_cast<Eigen::Index>(m.chosen.finest.size());
    out.push_back(count > 0 ? std::optional(resampled_fit(m, resampled.middleCols(next, count))) : std::nullopt);
    next += count;
  }
  return out;
}

}  // namespace

std::optional<order_fit> fit_order(std::span<const double> dt, std::span<const double> value, double floor) {
  const auto levels = finite_levels(dt, value, floor);
  const auto chosen = choose_levels(levels, dt.size() - levels.size());
  if (chosen.levels.size() < least_levels) return std::nullopt;
  return exact_fit(chosen, dt.size());
}

std::optional<order_fit> fit_power_law(std::span<const double> x, std::span<const double> value) {
  const auto all = every_level(finite_levels(x, value, 0));
  if (all.levels.size() < least_levels) return std::nullopt;
  return exact_fit(all, x.size());
}

std::vector<std::optional<order_fit>> fit_orders(std::span<const double> dt, std::span<const error_norm> norms,
                                                 double floor, std::uint64_t seed) {
  std::vector<moments> all;
  for (const auto& n : norms) {
    all.push_back({raised(*n.squares, n.p), 1 / n.p});
    choose_levels_of(dt, std::pow(floor, n.p), all.back());
  }
  return resampled_fits(all, seed);
}

std::optional<order_fit> fit_order(std::span<const double> dt, const squared_errors& e, double floor,
                                   std::uint64_t seed) {
  const error_norm rms{&e, 2};
  return fit_orders(dt, {&rms, 1}, floor, seed).front();
}

std::optional<double> power_of_means(std::span<const double> x, const squared_errors& values) {
  const auto all = every_level(levels_of_means(x, values, 1, 0));
  if (all.levels.size() < least_levels) return std::nullopt;
  return line_through(all.levels).slope;
}

std::optional<order_fit> fit_order_of_clear_means(std::span<const double> dt, squared_errors values, double resolved,
                                                  std::uint64_t seed) {
  for (int l = 0; l < values.levels; ++l) {
    const auto m = level_mean(values, l);
    const double sign = std::fabs(m.mean) < resolved * m.error ? 0 : m.mean < 0 ? -1 : 1;
    for (int path = 0; path < values.paths; ++path) values.at(path, l) *= sign;
  }
  moments m{std::move(values)};
  choose_levels_of(dt, 0, m);
  return resampled_fits({&m, 1}, seed).front();
}

}  // namespace polhode
