// SPDX-License-Identifier: Apache-2.0
// How far a long run of normals lies from the normal law, in standard deviations: one function for the short test and
// for the long one.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <gsl/gsl_cdf.h>

#include "ensemble/kernel.hpp"
#include "ensemble/noise/normal_block.hpp"
#include "ensemble/noise/paths.hpp"
#include "support/noise_sources.hpp"

namespace polhode::test {

struct deviation {
  std::string what;
  double z = 0;
};

/// The family, 29 tests a source and four sources, passes |z| < 5 with probability 1 - 7e-5 at least. The seeds are
/// fixed.
inline constexpr double family_bound = 5;
inline constexpr std::size_t tests_a_source = 29;

/// Products of pairs, and of their squares less one: both have mean 0 and, divided by 1 and 2, variance 1.
struct pair_sums {
  double count = 0, plain = 0, square = 0;
  void add(const double* a, const double* b, std::size_t n) {
    count += static_cast<double>(n);
    for (std::size_t i = 0; i < n; ++i) {
      plain += a[i] * b[i];
      square += (a[i] * a[i] - 1) * (b[i] * b[i] - 1) / 2;
    }
  }
  void add(const pair_sums& other) { count += other.count, plain += other.plain, square += other.square; }
};

class normal_sums {
 public:
  static constexpr int channels = 3, per_unit = 256, reach = 8, cells = 2 * reach * per_unit;
  static constexpr std::size_t row = block_lanes, step = channels * row;

  /// [step][channel][lane] of one block of paths from two seeds.
  void add(const std::vector<double>& x, const std::vector<double>& other_seed) {
    for (const double v : x) add(v);
    for (const double v : other_seed) add(v);
    seeds_.add(x.data(), other_seed.data(), x.size());
    for (const double* p = x.data(); p < x.data() + x.size(); p += row) {
      lanes_.add(p, p + 1, row - 1);
      counters_.add(p, p + 4, row - 4);
      if (p + step < x.data() + x.size()) steps_.add(p, p + step, row);
    }
    for (const double* p = x.data(); p < x.data() + x.size(); p += step) {
      channels_[0].add(p, p + row, row);
      channels_[1].add(p, p + 2 * row, row);
      channels_[2].add(p + row, p + 2 * row, row);
    }
  }

  void add(const normal_sums& other) {
    for (std::size_t k = 0; k < 8; ++k) power_[k] += other.power_[k];
    for (std::size_t i = 0; i < cells; ++i) cell_[i] += other.cell_[i];
    seeds_.add(other.seeds_), lanes_.add(other.lanes_), counters_.add(other.counters_), steps_.add(other.steps_);
    for (std::size_t i = 0; i < 3; ++i) channels_[i].add(other.channels_[i]);
  }

  std::vector<deviation> deviations() const {
    std::vector<deviation> out;
    moments(out);
    law(out);
    tails(out);
    for (const auto& [name, sums] : {std::pair{"seeds", seeds_},
                                     {"neighbouring lanes", lanes_},
                                     {"counters", counters_},
                                     {"steps", steps_},
                                     {"channels 0, 1", channels_[0]},
                                     {"channels 0, 2", channels_[1]},
                                     {"channels 1, 2", channels_[2]}}) {
      out.push_back({std::string("correlation of ") + name, sums.plain / std::sqrt(sums.count)});
      out.push_back({std::string("correlation of squares of ") + name, sums.square / std::sqrt(sums.count)});
    }
    return out;
  }

 private:
  void add(double x) {
    double power = 1;
    for (double& sum : power_) sum += power *= x;
    const double place = (x + reach) * per_unit;
    ++cell_[static_cast<std::size_t>(std::clamp(place, 0.0, cells - 1.0))];
  }

  double count() const {
    double n = 0;
    for (const auto c : cell_) n += static_cast<double>(c);
    return n;
  }
  static double edge(std::size_t i) { return static_cast<double>(i) / per_unit - reach; }
  static double two_sided(double p) { return p < 1 ? gsl_cdf_ugaussian_Qinv(p / 2) : 0.0; }

  void moments(std::vector<deviation>& out) const {
    const double n = count();
    const double exact[] = {0, 1, 0, 3, 0, 15, 0, 105}, variance[] = {1, 2, 15, 96, 945, 10170, 135135, 2016000};
    for (std::size_t k = 0; k < 8; ++k)
      out.push_back({"moment " + std::to_string(k + 1), (power_[k] / n - exact[k]) / std::sqrt(variance[k] / n)});
  }

  /// Pearson's chi-square on cells of width 1/256 with at least 100 expected, the rest as one cell (its z by Wilson and
  /// Hilferty), and Kolmogorov's distance on their edges: P(sqrt(n) D > s) < 2 exp(-2 s^2).
  void law(std::vector<deviation>& out) const {
    const double n = count();
    double chi = 0, used = 0, rest = n, rest_expected = n, below = 0, distance = 0;
    for (std::size_t i = 0; i < cells; ++i) {
      const auto seen = static_cast<double>(cell_[i]);
      const double a = edge(i), b = edge(i + 1);
      const double expected = n * (a < 0 ? gsl_cdf_ugaussian_P(b) - gsl_cdf_ugaussian_P(a)
                                         : gsl_cdf_ugaussian_Q(a) - gsl_cdf_ugaussian_Q(b));
      distance = std::max(distance, std::fabs((below += seen) / n - gsl_cdf_ugaussian_P(b)));
      if (expected < 100) continue;
      chi += (seen - expected) * (seen - expected) / expected;
      rest -= seen, rest_expected -= expected, ++used;
    }
    chi += (rest - rest_expected) * (rest - rest_expected) / rest_expected;
    const double spread = 2 / (9 * used);
    out.push_back({"chi-square", (std::cbrt(chi / used) - (1 - spread)) / std::sqrt(spread)});
    out.push_back({"Kolmogorov-Smirnov", two_sided(2 * std::exp(-2 * n * distance * distance))});
  }

  /// Counts beyond a bound are Poisson; the z has the same two-sided probability.
  void tails(std::vector<deviation>& out) const {
    for (const double bound : {4.0, 4.5, 5.0, 5.5, 6.0}) {
      unsigned seen = 0;
      for (std::size_t i = 0; i < cells; ++i)
        if (edge(i) >= bound || edge(i + 1) <= -bound) seen += static_cast<unsigned>(cell_[i]);
      const double expected = 2 * count() * gsl_cdf_ugaussian_Q(bound);
      const double fewer = gsl_cdf_poisson_P(seen, expected),
                   more = seen == 0 ? 1 : gsl_cdf_poisson_Q(seen - 1, expected);
      out.push_back({"count beyond " + std::to_string(bound).substr(0, 3), two_sided(2 * std::min(fewer, more))});
    }
  }

  std::array<double, 8> power_{};
  std::array<std::uint64_t, cells> cell_{};
  pair_sums seeds_, lanes_, counters_, steps_;
  std::array<pair_sums, 3> channels_;
};

/// At least `count` normals of a source, from two seeds; `distort` may spoil a piece, [step][channel][lane].
inline std::vector<deviation> deviations_of_normals(noise_source source, std::uint64_t count,
                                                    const std::function<void(std::vector<double>&)>& distort = {}) {
  constexpr int steps = 16384 / block_lanes;
  constexpr std::uint64_t piece = 2 * steps * normal_sums::step;
  normal_sums total;
  std::mutex adding;
  const auto threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  parallel_for(threads, static_cast<int>((count + piece - 1) / piece), [&](int i) {
    const auto draw = [&](std::uint64_t seed) {
      std::vector<double> x(piece / 2);
      fill_normals({seed, noise_kind::increment, static_cast<std::uint64_t>(i) * block_lanes, 0, steps,
                    normal_sums::channels, normal_sums::channels, 1.0, x.data(), source});
      if (distort) distort(x);
      return x;
    };
    normal_sums part;
    part.add(draw(1), draw(2));
    const std::lock_guard lock(adding);
    total.add(part);
  });
  return total.deviations();
}

}  // namespace polhode::test
