// SPDX-License-Identifier: Apache-2.0
#include "platform/stopping.hpp"

#include <utility>

namespace polhode {
namespace {

thread_local const std::atomic<bool>* flag_of_thread = nullptr;

}  // namespace

stoppable::stoppable(const std::atomic<bool>* flag) : before_(std::exchange(flag_of_thread, flag)) {}
stoppable::~stoppable() { flag_of_thread = before_; }

const std::atomic<bool>* stop_flag() { return flag_of_thread; }

void stop_if_asked() {
  if (flag_of_thread != nullptr && flag_of_thread->load(std::memory_order_relaxed)) throw stopped{};
}

}  // namespace polhode
