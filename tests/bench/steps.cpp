// Time per path and step of every scheme on the scene `paper`: with noise drawn by address, and on still
// increments (the step alone). Beside them, in the same run, what a programmer writes first: Eigen and
// std::normal_distribution.
#include <benchmark/benchmark.h>

#include <Eigen/Dense>
#include <random>

#include "ensemble/denormals.hpp"
#include "ensemble/paths.hpp"
#include "registry/scene.hpp"
#include "registry/systems.hpp"

namespace polhode {
namespace {

constexpr int steps = 256;
constexpr double dt = 0.01;

void per_path_step(benchmark::State& state, int paths) {
  state.counters["per_path_step"] = benchmark::Counter(
      static_cast<double>(steps * paths), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void run_scheme(benchmark::State& state, const scheme_entry& scheme, const subject& s, bool noisy) {
  const flush_denormals flushed;
  const auto stepper = scheme.make(dt);
  increment_buffer noise(*s.model, steps, scheme.needs_areas);
  auto states = replicated(s.scene.momentum);
  auto view = noise.zero(steps, dt);
  std::uint64_t step = 0;
  for (auto _ : state) {
    if (noisy) view = noise.fill(1, 0, step, steps, dt);
    step += steps;
    stepper->advance(states, view);
    benchmark::DoNotOptimize(states.data());
  }
  per_path_step(state, block_lanes);
}

void first_attempt_heun(benchmark::State& state) {
  using vector = Eigen::Vector3d;
  std::mt19937_64 generator(1);
  std::normal_distribution<double> normal;
  const vector inverse_inertia(1, 0.5, 1.0 / 3);
  vector pi(0.6, 0.48, 0.64);
  const auto slope = [&](const vector& p, const vector& noise) -> vector {
    const vector omega = inverse_inertia.cwiseProduct(p);
    return p.cross((omega + 0.5 * p.cross(omega)) * dt + noise);
  };
  for (auto _ : state)
    for (int i = 0; i < steps; ++i) {
      const vector noise = 0.5 * std::sqrt(dt) * vector(normal(generator), normal(generator), normal(generator));
      const vector first = slope(pi, noise);
      pi += 0.5 * (first + slope(pi + first, noise));
      benchmark::DoNotOptimize(pi.data());
    }
  per_path_step(state, 1);
}

}  // namespace
}  // namespace polhode

int main(int argc, char** argv) {
  using namespace polhode;
  static const subject s = bind_rigid_body(load_scene("paper"));
  for (const auto& scheme : s.schemes)
    for (const bool noisy : {false, true})
      benchmark::RegisterBenchmark((std::string(scheme.info.name) + (noisy ? "/independent" : "/step_alone")).c_str(),
                                   [&scheme, noisy](benchmark::State& state) { run_scheme(state, scheme, s, noisy); });
  benchmark::RegisterBenchmark("heun/eigen_and_std_normal", first_attempt_heun);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
