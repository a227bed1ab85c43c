// SPDX-License-Identifier: Apache-2.0
// The path itself: root-mean-square distance after a time from the path driven by the same noise, in units of |mu_0|.
#include <algorithm>
#include <cmath>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/coupled_increments.hpp"
#include "experiments/work_precision/path_cells.hpp"
#include "problem/vectors.hpp"
#include "selection/goal.hpp"

namespace polhode {
namespace {

constexpr int paths = 512, rough_paths = 64, plain_cells = 32;
constexpr double most_cells = 4e8;  // of a check: some seconds
constexpr double path_rounding = 1e-12;
constexpr double path_quantile = 1.96;

class path_goal final : public goal {
 public:
  path_goal(const context& c, const goal_question& q) : context_(c), time_(q.time), rate_(fastest_rate(c.subject)) {}

  std::vector<candidate> candidates(const subject& s) const override {
    std::vector<candidate> out;
    for (const auto& e : s.schemes)
      out.push_back({std::string(e.info.name), e, nullptr, strong_order_on(e.info, s.model->noise())});
    return out;
  }

  error_estimate error(const candidate& c, double dt, std::uint64_t seed) const override {
    return sampled(c, dt, seed, paths);
  }
  error_estimate rough_error(const candidate& c, double dt, std::uint64_t seed) const override {
    return sampled(c, dt, seed, rough_paths);
  }
  /// A mean square falls with dt but for terms of higher order: a few steps tell.
  int rungs() const override { return 3; }

  bool affordable(const candidate& c, double dt) const override {
    return time_ / dt * cells(c, dt) * paths <= most_cells;
  }

  double further_normals(const candidate& c, double dt) const override {
    const int channels = context_.subject.model->layout().active;
    return c.scheme.needs_areas && channels > 1 ? (cells(c, dt) - 1.0) * channels : 0;
  }

  double floor() const override { return path_rounding; }
  double longest_step() const override { return time_; }
  std::string unit() const override { return "|Pi_0|"; }

  std::vector<std::string> notes() const override {
    return {
        "root-mean-square distance of paths driven by one noise. Levy areas, where a scheme takes them, are those of "
        "the path, from the cells inside a step (Chen's relation): these cells are part of its cost"};
  }

 private:
  /// A step of the grid is so many cells of the truth.
  struct run_kernels {
    level_grid grid;
    int cells;
    std::unique_ptr<kernel> stepper, truth;
  };

  error_estimate sampled(const candidate& c, double dt, std::uint64_t seed, int count) const {
    const level_grid grid{time_, {static_cast<int>(std::lround(time_ / dt))}};
    const run_kernels run{grid, cells(c, dt), c.scheme.make(grid.dt()[0]),
                          context_.subject.model->reference(grid.dt()[0] / cells(c, dt))};
    std::vector<double> square(static_cast<std::size_t>(count));
    parallel_for(context_.threads, count / block_lanes,
                 [&](int block) { run_block(run, seed, block * block_lanes, square); });
    double sum = 0, squares = 0;
    for (const double x : square) {
      sum += x;
      squares += x * x;
    }
    const double mean = sum / count, error = std::sqrt(std::max(0.0, squares / count - mean * mean) / (count - 1));
    const double unit = length(context_.subject.scene.momentum), value = std::sqrt(mean) / unit;
    return {value, std::sqrt(mean + path_quantile * error) / unit - value};
  }

  /// A scheme without areas misses what the cells know of them: all but 1/cells of the mean square.
  int cells(const candidate& c, double dt) const {
    return c.scheme.needs_areas ? cells_for_areas(rate_, dt) : plain_cells;
  }

  void run_block(const run_kernels& run, std::uint64_t seed, int first_path, std::vector<double>& out) const {
    const auto& s = context_.subject;
    coupled_increments increments(*s.model, run.grid, run.cells, {context_.generator, noise_quality::precise});
    auto truth = replicated(s.scene.momentum), state = truth;
    for (int step = 0; step < run.grid.steps.front(); ++step) {
      run.truth->advance(truth, increments.fill(seed, static_cast<std::uint64_t>(first_path), step));
      run.stepper->advance(state, increments.level(0));
    }
    for (std::size_t i = 0; i < truth.size(); ++i)
      out[static_cast<std::size_t>(first_path) + i % block_lanes] += std::pow(state[i] - truth[i], 2);
  }

  context context_;
  double time_, rate_;
};

}  // namespace

std::unique_ptr<goal> make_path_goal(const context& c, const goal_question& q) {
  return std::make_unique<path_goal>(c, q);
}

}  // namespace polhode
