// SPDX-License-Identifier: Apache-2.0
// Sunny.jl tests its Langevin sampler by the energy of two spins, E = S1.S2, whose law is exp(-E / kT) on [-1, 1].
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "ensemble/noise/paths.hpp"
#include "reproduction/cases.hpp"
#include "reproduction/judged.hpp"
#include "reproduction/scenes.hpp"
#include "run/reference.hpp"
#include "statistics/resample.hpp"

namespace polhode {
namespace {

constexpr double temperature = 0.1, pair_dt = 0.02, tolerance = 0.05;
constexpr int forgotten = 1000, between = 500;  // steps before the first sample, and from one to the next
constexpr int energy_bins = 10, published_samples = 2000;

double exact_mean() { return temperature - 1 / std::tanh(1 / temperature); }

/// P(E <= e).
double exact_cdf(double e) { return std::expm1(-(e + 1) / temperature) / std::expm1(-2 / temperature); }

using chain = std::vector<double>;  // energies

/// The chains of a block of paths, all from the scene's state.
std::vector<chain> chains_of(const subject& s, const kernel& step, int block, int samples, std::uint64_t seed) {
  const auto& m = *s.model;
  increment_buffer noise(m, between, false, {noise_generator::philox, noise_quality::fast});
  auto states = replicated(s.scene.momentum);
  std::vector<chain> out(block_lanes);
  std::vector<double> energies(block_lanes), casimirs(2 * block_lanes);
  std::uint64_t taken = 0;
  const auto advance = [&](int steps) {
    const auto view = noise.fill(seed, static_cast<std::uint64_t>(block * block_lanes), taken, steps, pair_dt);
    step.advance(states, view);
    taken += static_cast<std::uint64_t>(steps);
  };
  for (int done = 0; done < forgotten; done += between) advance(between);
  for (int k = 0; k < samples; ++k) {
    advance(between);
    m.conserved(states, energies, casimirs);
    for (std::size_t lane = 0; lane < block_lanes; ++lane) out[lane].push_back(energies[lane]);
  }
  return out;
}

using chains_of_scheme = std::vector<chain>;

/// Of every scheme: all of them at once, so that no thread waits.
std::vector<chains_of_scheme> runs_of(const subject& s, const std::vector<std::string>& schemes, int samples,
                                      const reproduce_options& o) {
  const int blocks = by_effort(o.effort, 1, 1, 8), count = static_cast<int>(schemes.size());
  std::vector<chains_of_scheme> parts(static_cast<std::size_t>(blocks * count)), out(schemes.size());
  parallel_for(o.threads, blocks * count, [&](int job) {
    const auto step = scheme_of(s, schemes[static_cast<std::size_t>(job % count)]).make(pair_dt);
    parts[static_cast<std::size_t>(job)] = chains_of(s, *step, job / count, samples, o.seed);
  });
  for (std::size_t job = 0; job < parts.size(); ++job) {
    auto& all = out[job % schemes.size()];
    all.insert(all.end(), parts[job].begin(), parts[job].end());
  }
  return out;
}

/// The published test of one run: bins from its least to its greatest energy, the distance of the shares from the
/// exact ones in l2.
double distance_in_bins(const chain& c) {
  const auto [low, high] = std::ranges::minmax(c);
  const double width = (high - low) / energy_bins;
  std::array<double, energy_bins> share{};
  for (const double e : c)
    share[static_cast<std::size_t>(std::min((e - low) / width, energy_bins - 1.0))] +=
        1.0 / static_cast<double>(c.size());
  double square = 0;
  for (int i = 0; i < energy_bins; ++i) {
    const double exact = exact_cdf(low + (i + 1) * width) - exact_cdf(low + i * width);
    square += std::pow(share[static_cast<std::size_t>(i)] - exact, 2);
  }
  return std::sqrt(square);
}

double mean_of(const chain& c) { return std::accumulate(c.begin(), c.end(), 0.0) / static_cast<double>(c.size()); }

struct found_energy {
  interval_estimate mean, distance;
  double effective = 0;  ///< independent samples that a chain is worth, at most its own
};

found_energy found_in(const std::vector<chain>& chains) {
  std::vector<double> means, distances;
  double variance = 0;
  for (const auto& c : chains) {
    means.push_back(mean_of(c));
    distances.push_back(distance_in_bins(c));
    for (const double e : c) variance += std::pow(e - exact_mean(), 2) / static_cast<double>(c.size() * chains.size());
  }
  found_energy out;
  out.mean = mean_interval(means);
  const auto [low, high] = central_interval(distances, 0.95);
  out.distance = {mean_interval(distances).value, low, high};
  double scatter = 0;
  for (const double m : means) scatter += std::pow(m - out.mean.value, 2) / static_cast<double>(means.size() - 1);
  out.effective = std::min(variance / scatter, static_cast<double>(chains.front().size()));
  return out;
}

void compare_energies(const std::string& name, const chains_of_scheme& chains, report::reproduction& out) {
  const auto samples = chains.front().size();
  const auto found = found_in(chains);
  const auto what = fmt::format("{}, dt = {}", name, pair_dt);
  const double run = found.effective * published_samples / static_cast<double>(samples);
  out.numbers.push_back(compared(
      what + ": mean energy", exact_mean(), 1.96 * temperature / std::sqrt(run), found.mean,
      fmt::format("of {} runs of {} samples, each worth {:.0f} independent ones; tolerance: the scatter of one run of "
                  "2,000",
                  chains.size(), samples, found.effective)));
  if (samples == published_samples)
    out.numbers.push_back(
        compared_at_most(what + ": distance of a run's ten bins from the law", tolerance, found.distance,
                         fmt::format("mean and central 95 % over {} runs of {} samples; their test passes below 0.05",
                                     chains.size(), samples)));
  if (!out.curves.empty()) return;
  chain pooled;
  for (const auto& c : chains) pooled.insert(pooled.end(), c.begin(), c.end());
  report::reproduced_curve curve{
      "Law of the energy in ten bins from -1 to -0.4", "E", "share of a bin", "exact law (Sunny.jl)", what, false, {}};
  for (int i = 0; i < energy_bins; ++i) {
    const double a = -1 + 0.06 * i, b = a + 0.06;
    const auto count = std::ranges::count_if(pooled, [&](double e) { return e >= a && e < b; });
    curve.points.push_back(
        {(a + b) / 2, exact_cdf(b) - exact_cdf(a), static_cast<double>(count) / static_cast<double>(pooled.size())});
  }
  out.curves.push_back(std::move(curve));
}

}  // namespace

report::reproduction two_spins(const reproduce_options& o) {
  report::reproduction out;
  out.source =
      "Sunny.jl, test/test_samplers.jl, test item Spin chain (mode dipole), of commit 114ac7f: J = 1, kT = 0.1, "
      "damping 0.1, dt = 0.02, "
      "1000 steps to forget the start, 2000 samples 500 steps apart, atol = 0.05; src/Integrators.jl, Langevin";
  out.scene = fmt::format(
      "name = \"two_spins\"\nsystem = \"spins\"\ncount = 2\nexchange = 1.0\ntheta = 0.1\nsigma = {}   # sqrt(2 theta "
      "kT)\nmomentum = [0.0, 0.0, 1.0, 1.0, 0.0, 0.0]\nhorizon = 1.0\n",
      std::sqrt(2 * 0.1 * temperature));
  out.notes = {
      "Their step is Heun's, pulled back to the sphere after the predictor as well; heun_projected is pulled back once "
      "a step.",
      "Their exact shares of bins are Riemann sums with both ends of each bin, too great by 0.001 P; ours are "
      "integrals.",
      "All runs start at right angles, where theirs starts at random; 1000 steps forget either."};
  const auto s = scene_of(out.scene);
  const auto exact = reference(s, {"gibbs", "energy", {}, 0});
  out.numbers.push_back(compared("mean energy, exact", exact_mean(), 1e-9, within(exact.value, exact.uncertainty),
                                 "published: the law, whose mean is kT - coth(1/kT); ours: " + exact.method));
  const std::vector<std::string> schemes{"heun_projected", "lie_heun"};
  const auto all = runs_of(bind_scene(s), schemes, by_effort(o.effort, 125, published_samples, published_samples), o);
  for (std::size_t k = 0; k < schemes.size(); ++k) compare_energies(schemes[k], all[k], out);
  return out;
}

}  // namespace polhode
