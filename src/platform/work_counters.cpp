// SPDX-License-Identifier: Apache-2.0
#include "platform/work_counters.hpp"

#include <atomic>

#include "platform/cpu_profile.hpp"

namespace polhode {
namespace {

std::atomic<std::uint64_t> normals, path_steps, kernels;

}  // namespace

work_counters work_so_far() { return {normals, path_steps, kernels}; }

void count_normals(std::uint64_t n) { normals.fetch_add(n, std::memory_order_relaxed); }

void count_path_steps(std::uint64_t n, const char* scheme) {
  working_on(scheme);
  path_steps.fetch_add(n, std::memory_order_relaxed);
  kernels.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace polhode
