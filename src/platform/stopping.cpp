// SPDX-License-Identifier: Apache-2.0
#include "platform/stopping.hpp"

#include <utility>

namespace polhode {
namespace {

thread_local const stoppable* here = nullptr;

}  // namespace

stoppable::stoppable(const std::atomic<bool>* flag) : flag_(flag), outer_(here), before_(std::exchange(here, this)) {}
stoppable::stoppable(const stoppable* other) : flag_(nullptr), outer_(other), before_(std::exchange(here, this)) {}
stoppable::~stoppable() { here = before_; }

bool stoppable::asked() const {
  return (flag_ != nullptr && flag_->load(std::memory_order_relaxed)) || (outer_ != nullptr && outer_->asked());
}

const stoppable* stoppable_here() { return here; }

void stop_if_asked() {
  if (here != nullptr && here->asked()) throw stopped{};
}

}  // namespace polhode
