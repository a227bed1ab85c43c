// SPDX-License-Identifier: Apache-2.0
// An array between two pages that end whoever touches them.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <new>
#include <span>

namespace polhode::foreign {

/// Ends where the page behind it begins; what is left before it is checked by `touched`.
template <class T>
class guarded_array {
 public:
  explicit guarded_array(std::size_t count) : count_(count), page_(static_cast<std::size_t>(sysconf(_SC_PAGESIZE))) {
    inside_ = (count * sizeof(T) + page_ - 1) / page_ * page_;
    void* all = mmap(nullptr, inside_ + 2 * page_, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (all == MAP_FAILED) throw std::bad_alloc();
    base_ = static_cast<std::byte*>(all);
    if (inside_ > 0 && mprotect(base_ + page_, inside_, PROT_READ | PROT_WRITE) != 0) throw std::bad_alloc();
  }
  guarded_array(const guarded_array&) = delete;
  guarded_array& operator=(const guarded_array&) = delete;
  ~guarded_array() { munmap(base_, inside_ + 2 * page_); }

  std::span<T> values() { return {reinterpret_cast<T*>(base_ + page_ + inside_ - count_ * sizeof(T)), count_}; }
  T* data() { return values().data(); }

  /// Whether anything but zero stands before the array.
  bool touched() const {
    for (std::size_t i = 0; i < inside_ - count_ * sizeof(T); ++i)
      if (base_[page_ + i] != std::byte{}) return true;
    return false;
  }
  void write_protect() {
    if (inside_ > 0) mprotect(base_ + page_, inside_, PROT_READ);
  }

 private:
  std::size_t count_, page_, inside_ = 0;
  std::byte* base_ = nullptr;
};

}  // namespace polhode::foreign
