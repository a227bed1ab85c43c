// SPDX-License-Identifier: Apache-2.0
#include "reproduction/magpy_runs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <polhode/schemes/heun.hpp>
#include <polhode/schemes/implicit_midpoint.hpp>
#include <polhode/systems/varying_spin.hpp>
#include <random>

#include "ensemble/noise/paths.hpp"

namespace polhode {
namespace {

using magnetisation = vec<double, 3>;

/// dm = m x xi, xi = -F - alpha m x F: theta = alpha, and the signs of field and noise turned.
varying_spin system_of(const magpy_task& task) {
  const double s = -task.strength;
  const vec<double, 3> v[] = {{{s, 0, 0}}, {{0, s, 0}}, {{0, 0, s}}};
  return {spin(Eigen::Matrix3d::Zero(), {0, 0, -task.field}, task.alpha, spin::from_vectors(v)), state_noise::damped};
}

/// Standard normals of one run, [finest step][channel].
std::vector<double> numbers_of(std::uint64_t seed, const magpy_task& task) {
  std::mt19937_64 bits(seed);
  std::normal_distribution<double> normal;
  std::vector<double> out(static_cast<std::size_t>(3 * (task.coarsest << (task.levels - 1))));
  for (double& z : out) z = normal(bits);
  return out;
}

/// The increment of `fine` of the finest steps from `first` on; cut at sqrt(2 |ln dt|) standard deviations if asked
/// (Milstein, Repin, Tretyakov, SIAM J. Numer. Anal. 39 (2002) 2066, eq. 1.5).
magnetisation increment_of(const std::vector<double>& numbers, int first, int fine, double dt, bool cut) {
  magnetisation sum{};
  for (int i = 0; i < fine; ++i)
    for (int k = 0; k < 3; ++k) sum[k] += numbers[static_cast<std::size_t>(3 * (first + i) + k)];
  const double most = cut ? std::sqrt(2 * std::fabs(std::log(dt))) : HUGE_VAL, share = 1 / std::sqrt(double(fine));
  for (int k = 0; k < 3; ++k) sum[k] = std::sqrt(dt) * std::clamp(share * sum[k], -most, most);
  return sum;
}

magnetisation end_of(const std::vector<double>& numbers, const magpy_task& task, int level, magpy_method method) {
  const auto system = system_of(task);
  const int steps = task.coarsest << level, fine = 1 << (task.levels - 1 - level);
  const double dt = task.horizon / steps;
  magnetisation m{{1, 0, 0}};
  for (int i = 0; i < steps; ++i) {
    const wiener<double, 3> w{dt, increment_of(numbers, i * fine, fine, dt, method == magpy_method::midpoint_cut)};
    m = method == magpy_method::heun ? heun::step(system, m, w) : implicit_midpoint::step(system, m, w);
  }
  return m;
}

std::map<std::uint64_t, int> seeds_of(int runs) {
  std::map<std::uint64_t, int> out;
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(runs); ++i) ++out[13 * i * (i % 5)];
  return out;
}

}  // namespace

std::vector<double> magpy_task::dt() const {
  std::vector<double> out;
  for (int l = 0; l < levels; ++l) out.push_back(horizon / (coarsest << l));
  return out;
}

std::vector<double> magpy_differences(const magpy_task& task, magpy_method method, int runs, int threads) {
  const auto seeds = seeds_of(runs);
  const std::vector<std::pair<std::uint64_t, int>> list(seeds.begin(), seeds.end());
  const auto pairs = static_cast<std::size_t>(task.levels - 1);
  std::vector<double> each(list.size() * pairs);  // a place of its own for every run: the sum has one order
  parallel_for(threads, static_cast<int>(list.size()), [&](int run) {
    const auto numbers = numbers_of(list[static_cast<std::size_t>(run)].first, task);
    auto coarse = end_of(numbers, task, 0, method);
    for (std::size_t l = 0; l < pairs; ++l) {
      const auto fine = end_of(numbers, task, static_cast<int>(l) + 1, method);
      const auto apart = coarse - fine;
      each[static_cast<std::size_t>(run) * pairs + l] = std::sqrt(dot(apart, apart));
      coarse = fine;
    }
  });
  std::vector<double> out(pairs);
  for (std::size_t run = 0; run < list.size(); ++run)
    for (std::size_t l = 0; l < pairs; ++l) out[l] += each[run * pairs + l] * list[run].second / runs;
  return out;
}

double effective_magpy_runs(int runs) {
  double squares = 0;
  for (const auto& [seed, count] : seeds_of(runs)) squares += std::pow(static_cast<double>(count) / runs, 2);
  return 1 / squares;
}

}  // namespace polhode
