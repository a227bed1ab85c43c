// SPDX-License-Identifier: Apache-2.0
// What the sums of a noise_audit say: each as a normal deviate.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>

#include "statistics/distributions.hpp"
#include "statistics/noise/noise_audit.hpp"

namespace polhode {
namespace {

constexpr double tail_share = 6.334248366623996e-05;  // P(|z| > 4)

// A sum of n numbers of skewness s and excess kurtosis k has its tail beyond t raised by about
// exp(t^3 s / 6 n^(1/2) + t^4 k / 24 n): at t = 5.6 less than tenfold for so many. z z': k = 6; the square of an area:
// s up to 6; z^3 - 3z: k = 90; z^4 - 6z^2 + 3: s = 15.
constexpr double least_of_products = 1 << 9, least_of_cubes = 1 << 12, least_of_squares = 1 << 14,
                 least_of_fourths = 1 << 16;

/// Moments of u = A / (dt/2) of the area A^ij, made of n cells by Chen's relation: E u^2, E u^4, E u^2 z^2 with z the
/// increment of channel i, and E (u u')^2 with u' the area A^ik. Given channel i the areas are independent normals
/// whose variance is a quadratic form of its cells; the matrix of that is M^T M, M_ij = sign(j - i), with the
/// eigenvalues cot^2((2k + 1) pi / 2n) and 1^T M^T M 1 = n (n^2 - 1) / 3. n -> infinity: 1, 5, 5/3, 5/3. Surrogates: 1,
/// 3, 1, 1.
struct area_law {
  double square = 1, fourth = 3, own_channel = 1, shared_channel = 1;
  explicit area_law(int cells) {
    if (cells == 0) return;
    const double n = cells;
    double second = 0, quartic = 0;
    for (int k = 0; k < cells; ++k) {
      const double c = std::pow(1 / std::tan((2 * k + 1) * std::numbers::pi / (2 * n)), 2);
      second += c;
      quartic += c * c;
    }
    square = second / (n * n);
    shared_channel = (second * second + 2 * quartic) / std::pow(n, 4);
    fourth = 3 * shared_channel;
    own_channel = (second * n + 2 * n * (n * n - 1) / 3) / (n * n * n);
  }
};

/// In the order of increment.hpp.
std::vector<std::pair<int, int>> channel_pairs(int channels) {
  std::vector<std::pair<int, int>> out;
  for (int i = 0; i < channels; ++i)
    for (int j = i + 1; j < channels; ++j) out.emplace_back(i, j);
  return out;
}

/// Of a Poisson count, by its exact tails.
double poisson_deviate(double count, double mean) {
  if (count < mean) return -normal_deviate(std::min(0.5, poisson_lower(count, mean)));
  return normal_deviate(std::min(0.5, poisson_upper(count, mean)));
}

/// Of a sum of so many squares, by the cube root.
double chi_square_deviate(double sum, double numbers) {
  const double spread = 2 / (9 * numbers);
  return (std::cbrt(sum / numbers) - (1 - spread)) / std::sqrt(spread);
}

}  // namespace

void noise_audit::compare_heads(std::vector<noise_deviation>& out) const {
  const auto blocks = heads_.size();
  double sum = 0, count = 0, lane_sum = 0, far_sum = 0;
  for (std::size_t b = 0; b < blocks; ++b) {
    for (std::size_t apart = 1; apart <= b; apart *= 2)
      for (std::size_t k = 0; k < heads_[b].size(); ++k) {
        sum += (heads_[b][k] * heads_[b - apart][k]).sum();
        count += lanes;
      }
    for (const auto& x : heads_[b]) {
      lane_sum += lanes_apart(x, 1);
      far_sum += lanes_apart(x, lanes / 2);
    }
  }
  const double channels = static_cast<double>(blocks) * channels_;
  if (count > 0) out.push_back({"one block times another", sum / std::sqrt(count)});
  if (channels > 0) {
    out.push_back({"first steps, lane times next lane", lane_sum / std::sqrt(channels * (lanes - 1))});
    out.push_back({"first steps, lane times lane + 32", far_sum / std::sqrt(channels * lanes / 2)});
  }
}

void noise_audit::compare_paths(std::vector<noise_deviation>& out) const {
  out.push_back({"number of paths that start alike", normal_deviate(path_audit_.probability_of_repeats() / 2)});
  out.push_back({paths_ ? "product of two steps within 64" : "product of two lanes",
                 normal_deviate(path_audit_.probability_of_products() / 2)});
}

void noise_audit::add_area_deviations(const listed& add) const {
  const area_law law(cells_);
  const auto pairs = pairs_ > 0 ? channel_pairs(channels_) : std::vector<std::pair<int, int>>{};
  int both = 0;
  for (int p = 0; p < pairs_; ++p) {
    const auto [i, j] = pairs[static_cast<std::size_t>(p)];
    const auto name = fmt::format("area {}{}", i + 1, j + 1);
    add("mean of " + name, {sums_.area[p], area_all_, law.square, least_of_products});
    add("variance of " + name, {sums_.area_square[p] - area_all_ * law.square, area_all_,
                                law.fourth - law.square * law.square, least_of_squares});
    for (int k = 0; k < channels_; ++k)
      add(fmt::format("{} times channel {}", name, k + 1),
          {sums_.area_increment[p * channels_ + k], area_close_, k == i || k == j ? law.own_channel : law.square,
           least_of_cubes});
    for (int q = p + 1; q < pairs_; ++q) {
      const auto [a, b] = pairs[static_cast<std::size_t>(q)];
      const bool shared = i == a || i == b || j == a || j == b;
      add(fmt::format("{} times area {}{}", name, a + 1, b + 1),
          {sums_.areas[both++], area_close_, shared ? law.shared_channel : law.square * law.square, least_of_squares});
    }
  }
}

std::vector<noise_deviation> noise_audit::deviations() const {
  std::vector<noise_deviation> out;
  const auto add = [&](const std::string& what, const summed& s) {
    if (s.numbers >= s.least) out.push_back({what, s.sum / std::sqrt(s.numbers * s.variance)});
  };
  int pair = 0;
  for (int k = 0; k < channels_; ++k) {
    const auto of = [&](const char* what) { return fmt::format("{} of channel {}", what, k + 1); };
    const auto lane = [&](const char* what) { return of(paths_ ? "step times a later step" : what); };
    add(of("mean"), {sums_.mean[k], all_, 1, 1});
    if (all_ > 0) out.push_back({of("variance"), chi_square_deviate(sums_.square[k], all_)});
    add(of("third moment"), {sums_.skew[k], close_, 6, least_of_cubes});
    add(of("fourth moment"), {sums_.kurtosis[k], close_, 24, least_of_fourths});
    add(lane("step times next step"), {sums_.next_step[k], followed_, 1, least_of_products});
    add(lane("lane times next lane"), {sums_.next_lane[k], close_ * (lanes - 1) / lanes, 1, least_of_products});
    add(lane("lane times lane + 32"), {sums_.far_lane[k], close_ / 2, 1, least_of_products});
    if (close_ > 0) out.push_back({of("tail beyond 4"), poisson_deviate(sums_.tail[k], close_ * tail_share)});
    for (int j = k + 1; j < channels_; ++j)
      add(fmt::format("channel {} times channel {}", k + 1, j + 1),
          {sums_.channels[pair++], close_, 1, least_of_products});
  }
  const auto areas = static_cast<std::ptrdiff_t>(out.size());
  add_area_deviations(add);
  for (auto& d : out | std::views::drop(areas)) d.of_area = true;
  compare_heads(out);
  compare_paths(out);
  return out;
}

double audit_threshold(std::size_t deviations) {
  return normal_deviate(audit_false_alarm / 2 / std::max(1.0, static_cast<double>(deviations)));
}

}  // namespace polhode
