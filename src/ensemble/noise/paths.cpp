// SPDX-License-Identifier: Apache-2.0
#include "ensemble/noise/paths.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>

#include "ensemble/noise/noise_defect.hpp"
#include "ensemble/noise/normal_block.hpp"
#include "platform/cpu_profile.hpp"
#include "platform/denormals.hpp"
#include "platform/stopping.hpp"
#include "platform/work_counters.hpp"

namespace polhode {

void parallel_for(int threads, int count, const std::function<void(int)>& work) {
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::mutex failing;
  const auto worker = [&, asker = stoppable_here()] {
    const flush_denormals flushed;
    const stoppable as_asked_for(asker);
    for (int i = next++; i < count; i = next++) try {
        stop_if_asked();
        working_on("");
        work(i);
      } catch (...) {
        const std::lock_guard lock(failing);
        if (!failure) failure = std::current_exception();
        next = count;
      }
  };
  {
    std::vector<std::jthread> others;
    try {
      for (int t = 1; t < std::min(threads, count); ++t) others.emplace_back(worker);
    } catch (const std::system_error&) {  // the system has no more threads: those there are do the work
    }
    worker();
  }
  if (failure) std::rethrow_exception(failure);
}

increment_buffer::increment_buffer(const model& m, int steps, bool with_areas, noise_source source)
    : layout_(m.layout()),
      source_(source),
      dw_(source.quality == noise_quality::fast ? 0 : layout_.increments(steps, block_lanes)),
      singles_(source.quality == noise_quality::fast ? layout_.increments(steps, block_lanes) : 0),
      area_(with_areas ? layout_.areas(steps, block_lanes) : 0) {}

increment_view increment_buffer::fill(std::uint64_t seed, std::uint64_t first_path, std::uint64_t first_step, int steps,
                                      double dt) {
  stop_if_asked();
  const auto* defect = noise_defect_in_force();
  if (defect) first_path = defect->path(first_path);
  const auto draw = [&](noise_kind kind, int rows, int wanted, double scale, lane_vector<double>& out, float* singles) {
    fill_normals({seed, kind, first_path, first_step, steps, rows, wanted, scale, out.data(), source_, singles});
    count_normals(static_cast<std::uint64_t>(steps) * static_cast<std::uint64_t>(wanted) * block_lanes);
  };
  const double scale = std::sqrt(dt);
  draw(noise_kind::increment, layout_.channels, layout_.active, scale, dw_,
       singles_.empty() ? nullptr : singles_.data());
  if (!area_.empty()) draw(noise_kind::area, layout_.pairs(), layout_.active_pairs(), dt / 2, area_, nullptr);
  if (defect) defect->spoil({first_path, first_step, block_lanes, steps, layout_, dt, dw_, singles_, area_});
  return {steps, dw_, area_, singles_, scale};
}

std::vector<double> replicated(std::span<const double> state) {
  std::vector<double> out;
  out.reserve(state.size() * block_lanes);
  for (const double value : state) out.insert(out.end(), block_lanes, value);
  return out;
}

std::vector<double> lane_of(std::span<const double> states, int lane, int dimension) {
  std::vector<double> out(static_cast<std::size_t>(dimension));
  for (int k = 0; k < dimension; ++k)
    out[static_cast<std::size_t>(k)] = states[static_cast<std::size_t>(k * block_lanes + lane)];
  return out;
}

}  // namespace polhode
