#include "statistics/order_fit.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "statistics/distributions.hpp"
#include "statistics/resample.hpp"

namespace polhode {
namespace {

constexpr int least_levels = 4, replicates = 400;
constexpr const char* every_point = "every point that is finite and above zero";
constexpr double off_the_line = 0.05, standard_errors = 3;

struct points {
  std::vector<double> x, y, weight;
  void add(double px, double py, double w) {
    x.push_back(px);
    y.push_back(py);
    weight.push_back(w);
  }
};

struct line {
  double intercept = 0, slope = 0;
  double at(double x) const { return intercept + slope * x; }
};

line weighted_line(const points& p) {
  double w = 0, mx = 0, my = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    w += p.weight[i];
    mx += p.weight[i] * p.x[i];
    my += p.weight[i] * p.y[i];
  }
  mx /= w;
  my /= w;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    sxx += p.weight[i] * (p.x[i] - mx) * (p.x[i] - mx);
    sxy += p.weight[i] * (p.x[i] - mx) * (p.y[i] - my);
  }
  return {my - sxy / sxx * mx, sxy / sxx};
}

/// Levels in order of decreasing dt, as (log2 dt, log2 value, standard error of log2 value).
struct level {
  int index;
  double x, y, error;
};

points points_of(std::span<const level> levels) {
  points p;
  for (const level& l : levels) p.add(l.x, l.y, l.error > 0 ? 1 / (l.error * l.error) : 1);
  return p;
}

/// How far the coarsest level lies off the line through the others.
double off_the_others(points p) {
  const double x = p.x.front(), y = p.y.front();
  p.x.erase(p.x.begin());
  p.y.erase(p.y.begin());
  p.weight.erase(p.weight.begin());
  return y - weighted_line(p).at(x);
}

double slope_at_the_finest(const points& p) {
  const std::size_t n = p.x.size();
  return (p.y[n - 1] - p.y[n - 2]) / (p.x[n - 1] - p.x[n - 2]);
}

struct selection {
  std::vector<level> finest, levels;  ///< that may take part, and that do: the last of them
  std::string rule;
};

std::vector<level> asymptotic_part(std::vector<level> kept) {
  while (static_cast<int>(kept.size()) > least_levels) {
    const double off = std::fabs(off_the_others(points_of(kept)));
    if (off <= off_the_line || off <= standard_errors * kept.front().error) break;
    kept.erase(kept.begin());
  }
  return kept;
}

/// The rule of the header.
selection select_levels(std::vector<level> all, int left_out_at_floor) {
  std::ranges::sort(all, [](const level& a, const level& b) { return a.x > b.x; });
  const int spare = std::max(0, static_cast<int>(all.size()) - fitted_levels);
  const std::vector<level> finest(all.begin() + spare, all.end());
  const auto kept = asymptotic_part(finest);
  const auto early = finest.size() - kept.size();
  return {finest, kept,
          fmt::format("{} levels used; left out: {} coarser than the finest {}, {} pre-asymptotic, {} at the "
                      "rounding floor or not finite",
                      kept.size(), spare, fitted_levels, early, left_out_at_floor)};
}

order_fit result_of(const selection& s, const line& l, double low, double high, std::size_t count) {
  order_fit fit{l.slope, low, high, std::exp2(l.intercept), std::vector<bool>(count, false), s.rule, true, {}};
  for (const level& kept : s.levels) fit.used[static_cast<std::size_t>(kept.index)] = true;
  return fit;
}

double half_width_of_residuals(const points& p, const line& l) {
  const auto n = static_cast<double>(p.x.size());
  double residual = 0, mean = 0, sxx = 0;
  for (const double x : p.x) mean += x / n;
  for (std::size_t i = 0; i < p.x.size(); ++i) {
    residual += std::pow(p.y[i] - l.at(p.x[i]), 2);
    sxx += std::pow(p.x[i] - mean, 2);
  }
  return student_t_quantile(0.975, n - 2) * std::sqrt(residual / (n - 2) / sxx);
}

/// The levels that are finite and above the floor, without sampling error.
std::vector<level> finite_levels(std::span<const double> x, std::span<const double> value, double floor) {
  std::vector<level> levels;
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::isfinite(value[i]) && value[i] > floor)
      levels.push_back({static_cast<int>(i), std::log2(x[i]), std::log2(value[i]), 0});
  return levels;
}

order_fit exact_fit(const selection& s, std::size_t count) {
  const points p = points_of(s.levels);
  const line l = weighted_line(p);
  const double half = half_width_of_residuals(p, l);
  auto fit = result_of(s, l, l.slope - half, l.slope + half, count);
  bool straight = std::fabs(off_the_others(p)) <= off_the_line;  // what scatters without sampling is curvature
  for (std::size_t i = 0; i < p.x.size(); ++i) straight = straight && std::fabs(p.y[i] - l.at(p.x[i])) <= off_the_line;
  fit.settled = straight;
  fit.finest.value = fit.finest.low = fit.finest.high = slope_at_the_finest(p);
  return fit;
}

using values_of_paths = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// Means over resampled paths, [replicate][column] of [path][column]. How often each path is drawn is a matrix, so that
/// all columns, of one quantity or of several, are one product.
Eigen::MatrixXd resampled_means(const values_of_paths& values, std::uint64_t seed) {
  const auto paths = static_cast<int>(values.rows());
  values_of_paths drawn = values_of_paths::Zero(replicates, paths);
  for (int r = 0; r < replicates; ++r)
    for (const int path : resample(seed, r, paths)) drawn(r, path) += 1;
  return drawn * values / paths;
}

auto matrix_of(const squared_errors& e) {
  return Eigen::Map<const values_of_paths>(e.values.data(), e.paths, e.levels);
}

}  // namespace

std::optional<order_fit> fit_order(std::span<const double> dt, std::span<const double> value, double floor) {
  const auto levels = finite_levels(dt, value, floor);
  const auto s = select_levels(levels, static_cast<int>(dt.size() - levels.size()));
  if (s.levels.size() < least_levels) return std::nullopt;
  return exact_fit(s, dt.size());
}

std::optional<order_fit> fit_power_law(std::span<const double> x, std::span<const double> value) {
  const auto points = finite_levels(x, value, 0);
  const selection all{points, points, every_point};
  if (all.levels.size() < least_levels) return std::nullopt;
  return exact_fit(all, x.size());
}

mean_and_error level_mean(const squared_errors& e, int level) {
  double mean = 0, square = 0;
  for (int path = 0; path < e.paths; ++path) mean += e.at(path, level) / e.paths;
  for (int path = 0; path < e.paths; ++path) square += std::pow(e.at(path, level) - mean, 2);
  return {mean, std::sqrt(square / e.paths / std::max(1, e.paths - 1))};
}

namespace {

/// Of which the order of mean^power is asked, and the levels that take part.
struct moments {
  squared_errors values;
  double power = 1;
  bool every_level = false;
  selection chosen = {};
};

void select_levels_of(std::span<const double> dt, double least_mean, moments& m) {
  std::vector<level> levels;
  for (int i = 0; i < m.values.levels; ++i) {
    const auto at = level_mean(m.values, i);
    if (!std::isfinite(at.mean) || at.mean <= least_mean) continue;
    levels.push_back({i, std::log2(dt[static_cast<std::size_t>(i)]), m.power * std::log2(at.mean),
                      std::max(1e-12, m.power * at.error / at.mean / std::log(2.0))});
  }
  const auto left_out = m.values.levels - static_cast<int>(levels.size());
  m.chosen = m.every_level ? selection{levels, levels, every_point} : select_levels(std::move(levels), left_out);
  if (m.chosen.levels.size() < least_levels) m.chosen = {};
}

/// `resampled`: means of the replicates, [replicate][level that may take part]. Each chooses its own levels for its
/// slope, as the choice is part of what would come out otherwise.
order_fit resampled_fit(const moments& m, const Eigen::Ref<const Eigen::MatrixXd>& resampled) {
  const auto early = m.chosen.finest.size() - m.chosen.levels.size();
  const points p = points_of(m.chosen.levels);
  const line l = weighted_line(p);
  const double last = slope_at_the_finest(p);
  std::vector<double> slopes, off, finest;
  auto levels = m.chosen.finest;
  for (Eigen::Index r = 0; r < resampled.rows(); ++r) {
    for (std::size_t k = 0; k < levels.size(); ++k)
      levels[k].y = m.power * std::log2(resampled(r, static_cast<Eigen::Index>(k)));
    slopes.push_back(weighted_line(points_of(m.every_level ? levels : asymptotic_part(levels))).slope);
    const auto same = points_of(std::span(levels).subspan(early));
    off.push_back(off_the_others(same));
    finest.push_back(slope_at_the_finest(same));
  }
  const auto [low, high] = central_interval(slopes, 0.95);
  const auto [least, most] = central_interval(off, 0.95);
  auto fit = result_of(m.chosen, l, low, high, static_cast<std::size_t>(m.values.levels));
  fit.settled = least <= off_the_line && most >= -off_the_line;
  const auto [slowest, fastest] = central_interval(finest, 0.95);
  fit.finest = {last, slowest, fastest};
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

squared_errors raised(const squared_errors& e, double p) {
  squared_errors out{e.paths, e.levels, std::vector<double>(static_cast<std::size_t>(e.paths * e.levels))};
  for (std::size_t i = 0; i < out.values.size(); ++i)
    out.values[i] = p == 2   ? e.values[i]
                    : p == 4 ? e.values[i] * e.values[i]
                    : p == 1 ? std::sqrt(e.values[i])
                             : std::pow(e.values[i], p / 2);
  return out;
}

}  // namespace

mean_and_error level_norm(const squared_errors& e, double p, int level) {
  squared_errors one{e.paths, 1, {}};
  for (int path = 0; path < e.paths; ++path) one.values.push_back(e.at(path, level));
  const auto m = level_mean(raised(one, p), 0);
  const double norm = std::pow(m.mean, 1 / p);
  return {norm, m.mean > 0 ? norm * m.error / m.mean / p : 0};
}

std::vector<std::optional<order_fit>> fit_orders(std::span<const double> dt, std::span<const error_norm> norms,
                                                 double floor, std::uint64_t seed) {
  std::vector<moments> all;
  for (const auto& n : norms) {
    all.push_back({raised(*n.squares, n.p), 1 / n.p});
    select_levels_of(dt, std::pow(floor, n.p), all.back());
  }
  return resampled_fits(all, seed);
}

std::optional<order_fit> fit_order(std::span<const double> dt, const squared_errors& e, double floor,
                                   std::uint64_t seed) {
  const error_norm rms{&e, 2};
  return fit_orders(dt, {&rms, 1}, floor, seed).front();
}

std::optional<order_fit> fit_power_law_of_means(std::span<const double> x, const squared_errors& values,
                                                std::uint64_t seed) {
  moments m{values, 1, true};
  select_levels_of(x, 0, m);
  return resampled_fits({&m, 1}, seed).front();
}

std::optional<order_fit> fit_order_of_clear_means(std::span<const double> dt, squared_errors values, double clear,
                                                  std::uint64_t seed) {
  for (int l = 0; l < values.levels; ++l) {
    const auto m = level_mean(values, l);
    const double sign = std::fabs(m.mean) < clear * m.error ? 0 : m.mean < 0 ? -1 : 1;
    for (int path = 0; path < values.paths; ++path) values.at(path, l) *= sign;
  }
  moments m{std::move(values)};
  select_levels_of(dt, 0, m);
  return resampled_fits({&m, 1}, seed).front();
}

error_model fit_error_model(std::span<const double> dt, const squared_errors& e, const std::vector<bool>& used,
                            double order, std::uint64_t seed, int powers) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) kept.push_back(i);
  const auto n = static_cast<Eigen::Index>(kept.size());
  Eigen::MatrixXd design(n, 1 + powers);
  Eigen::VectorXd weight(n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const std::size_t level = kept[static_cast<std::size_t>(k)];
    design(k, 0) = 1;
    for (int i = 0; i < powers; ++i) design(k, 1 + i) = std::pow(dt[level], 2 * order + i);
    weight[k] = 1 / std::max(1e-300, level_mean(e, static_cast<int>(level)).error);
  }
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> with_limit(weight.asDiagonal() * design.leftCols(3)),
      without(weight.asDiagonal() * design.rightCols(powers));
  const auto coefficients = [&](const Eigen::RowVectorXd& mean) {
    Eigen::VectorXd y(n);
    for (Eigen::Index k = 0; k < n; ++k) y[k] = weight[k] * mean[k];
    return std::pair{Eigen::VectorXd(with_limit.solve(y))[0], Eigen::VectorXd(without.solve(y))[0]};
  };
  std::vector<double> limits, leading;
  values_of_paths values(e.paths, n);
  for (Eigen::Index k = 0; k < n; ++k)
    values.col(k) = matrix_of(e).col(static_cast<Eigen::Index>(kept[static_cast<std::size_t>(k)]));
  const auto resampled = resampled_means(values, seed);
  for (Eigen::Index r = 0; r < resampled.rows(); ++r) {
    const auto [square, coefficient] = coefficients(resampled.row(r));
    limits.push_back(square);
    leading.push_back(coefficient);
  }
  const auto [square, coefficient] = coefficients(values.colwise().mean());
  const auto [low, high] = central_interval(limits, 0.95);
  const auto [least, most] = central_interval(leading, 0.95);
  const auto distance = [](double x) { return std::sqrt(std::max(0.0, x)); };
  return {{distance(square), distance(low), distance(high)}, {coefficient, least, most}};
}

}  // namespace polhode
