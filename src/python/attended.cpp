// SPDX-License-Identifier: Apache-2.0
#include "python/attended.hpp"

namespace polhode::python {

namespace py = pybind11;

void attendance::stop(std::exception_ptr why) {
  const std::lock_guard lock(guard_);
  if (!why_) why_ = std::move(why);
  stop_ = true;
}

progress_sink attendance::sink() {
  return [this](double share, std::string_view what) {
    stop_if_asked();
    const std::lock_guard lock(guard_);
    share_ = share;
    what_ = what;
  };
}

void attendance::look() {
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (stop_ && caller_ != 0) PyThreadState_SetAsyncExc(caller_, PyExc_KeyboardInterrupt);
    if (progress_.is_none() || stop_) return;
    std::unique_lock lock(guard_);
    if (share_ == told_) return;
    told_ = share_;
    const auto what = what_;
    lock.unlock();
    progress_(told_, what);
  } catch (...) {
    stop(std::current_exception());
  }
}

void attendance::rethrow() const {
  const std::lock_guard lock(guard_);
  if (why_) std::rethrow_exception(why_);
}

}  // namespace polhode::python
