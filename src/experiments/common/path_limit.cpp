// SPDX-License-Identifier: Apache-2.0
#include "experiments/common/path_limit.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "problem/noise_covariance.hpp"

namespace polhode {
namespace {

using report::verdict_kind;

squared_errors room(int paths, int levels) {
  return {paths, levels, std::vector<double>(static_cast<std::size_t>(paths * levels))};
}

double lane_product(const std::vector<double>& a, const std::vector<double>& b, int lane) {
  double sum = 0;
  for (auto i = static_cast<std::size_t>(lane); i < a.size(); i += block_lanes) sum += a[i] * b[i];
  return sum;
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> out(a);
  for (std::size_t i = 0; i < a.size(); ++i) out[i] -= b[i];
  return out;
}

verdict_kind worse(verdict_kind a, verdict_kind b) {
  if (a == verdict_kind::refuted || b == verdict_kind::refuted) return verdict_kind::refuted;
  return a == verdict_kind::holds ? b : a;
}

/// A scheme that is its twin but for rounding scatters by nothing else.
constexpr double rounding = 1e-12;

verdict_kind judge_strength(const multiplier& m, double margin) {
  if (!std::isfinite(m.error.value)) return verdict_kind::inconclusive;
  if (std::fabs(m.error.value) > std::max(m.sure, rounding)) return verdict_kind::refuted;
  return judge(0, m.error.low, m.error.high, margin) == verdict_kind::holds ? verdict_kind::holds
                                                                            : verdict_kind::inconclusive;
}

}  // namespace

double gap_order(const subject& s, const scheme_info& info) {
  const auto& strong = info.strong_order;
  if (s.model->noise() == noise_class::general && strong.general < 1 && info.weak_order.general > 1) {
    const auto covariance = covariance_of_noise(s.scene);
    if (covariance.fullPivLu().rank() < covariance.rows()) return strong.general;
  }
  return std::max(strong.commuting, strong.general);
}

path_record::path_record(int paths, int levels, int directions)
    : error(room(paths, levels)),
      gap(room(paths, levels)),
      response(paths, directions, std::min(levels, response_levels)),
      areas{room(paths, levels), room(paths, levels)} {}

double noise_effect::rms(int paths) const {
  double sum = 0;
  for (int p = 0; p < paths; ++p) sum += squares[static_cast<std::size_t>(p)];
  return std::sqrt(sum / paths);
}

void keep(const std::vector<std::vector<double>>& states, const driven_block& truth,
          const std::vector<std::vector<double>>& responses, bool with_areas, int first_path, path_record& out) {
  const int levels = static_cast<int>(states.size()), skipped = levels - out.response.levels;
  const int directions = out.response.directions;
  for (int l = 0; l < levels; ++l) {
    const auto at = static_cast<std::size_t>(l);
    const auto error = difference(states[at], truth.truth());
    const auto gap = with_areas ? error : difference(states[at], truth.twin(at));
    const auto by_areas = difference(truth.truth(), truth.twin(at));
    for (int lane = 0; lane < block_lanes; ++lane) {
      out.error.at(first_path + lane, l) = lane_product(error, error, lane);
      out.gap.at(first_path + lane, l) = lane_product(gap, gap, lane);
      out.areas.product.at(first_path + lane, l) = lane_product(error, by_areas, lane);
      out.areas.square.at(first_path + lane, l) = lane_product(by_areas, by_areas, lane);
      if (l < skipped) continue;
      double* response = out.response.response_of(first_path + lane, l - skipped);
      for (int k = 0; k < directions; ++k)
        response[k] = lane_product(gap, responses[static_cast<std::size_t>(k)], lane);
    }
  }
  for (int lane = 0; lane < block_lanes; ++lane) {
    double* gram = out.response.gram_of(first_path + lane);
    for (int j = 0; j < directions; ++j)
      for (int k = 0; k < directions; ++k)
        gram[j * directions + k] =
            lane_product(responses[static_cast<std::size_t>(j)], responses[static_cast<std::size_t>(k)], lane);
  }
}

void keep(const std::vector<std::vector<double>>& responses, const std::vector<direction>& directions, int first_path,
          noise_effect& out) {
  std::vector<double> sum(responses.front().size());
  for (std::size_t k = 0; k < directions.size(); ++k)
    if (directions[k].channel >= 0)
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += responses[k][i];
  for (int lane = 0; lane < block_lanes; ++lane)
    out.squares[static_cast<std::size_t>(first_path + lane)] = lane_product(sum, sum, lane);
}

path_limit limit_of(const context& c, const scheme_info& info, std::span<const double> dt, const path_record& paths,
                    const noise_effect& noise, int cells) {
  const int count = paths.gap.paths;
  const double effect = noise.rms(count), order = gap_order(c.subject, info);
  path_limit out{{NAN, NAN, NAN}, (order < 1 ? 1 : 0.1) * distance_share * effect, {}, {}};
  const auto fit = fit_order(dt, paths.gap, 0, c.seed);
  if (!fit) return out;
  out.distance = fit_error_model(dt, paths.gap, fit->used, order, c.seed).limit;
  out.strengths =
      effective_multipliers(dt.last(static_cast<std::size_t>(paths.response.levels)), paths.response, count, cells);
  for (const auto& m : out.strengths) out.margins.push_back(strength_margin * std::max(1.0, effect / m.size));
  return out;
}

bool tight(const path_limit& limit) {
  if (!std::isfinite(limit.distance.value)) return true;  // more paths would not help
  if (half_width(limit.distance) > limit.bound / 3) return false;
  for (std::size_t k = 0; k < limit.strengths.size(); ++k)
    if (limit.strengths[k].known && half_width(limit.strengths[k].error) > limit.margins[k] / 3) return false;
  return true;
}

report::verdict judge_limit(const path_limit& limit, const std::vector<direction>& directions, double size) {
  const auto& d = limit.distance;
  if (!std::isfinite(d.value)) return judge_distance({NAN, NAN, NAN}, 0, "no usable levels");
  auto v = judge_distance({d.value / size, d.low / size, d.high / size}, limit.bound / size, "");
  std::vector<std::string> strengths;
  for (std::size_t k = 0; k < limit.strengths.size(); ++k) {
    const auto& m = limit.strengths[k];
    if (!m.known) continue;
    v.kind = worse(v.kind, judge_strength(m, limit.margins[k]));
    strengths.push_back(fmt::format("{} {:.5f} [{:.5f}, {:.5f}]", directions[k].name, 1 + m.error.value,
                                    1 + m.error.low, 1 + m.error.high));
  }
  v.reason = fmt::format(
      "distance from the solution as dt -> 0, in units of |mu_0|: at most {:.2g}, bound {:.2g}; strengths as dt -> 0: "
      "{}",
      d.high / size, limit.bound / size, fmt::join(strengths, ", "));
  return v;
}

}  // namespace polhode
