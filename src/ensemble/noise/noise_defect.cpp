// SPDX-License-Identifier: Apache-2.0
#include "ensemble/noise/noise_defect.hpp"

#include <atomic>

namespace polhode {
namespace {

std::atomic<const noise_defect*> in_force{nullptr};

}  // namespace

planted_noise_defect::planted_noise_defect(const noise_defect& d) { in_force = &d; }
planted_noise_defect::~planted_noise_defect() { in_force = nullptr; }
const noise_defect* noise_defect_in_force() { return in_force.load(std::memory_order_relaxed); }

}  // namespace polhode
