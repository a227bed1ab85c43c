// SPDX-License-Identifier: Apache-2.0
// A kernel that does as another one does, but for what a test overrides.
#pragma once

#include <memory>
#include <utility>

#include "ensemble/kernel.hpp"

namespace polhode::test {

/// Who overrides one `advance` says `using kernel_decorator::advance` for the other.
class kernel_decorator : public kernel {
 public:
  explicit kernel_decorator(std::unique_ptr<kernel> inner) : inner_(std::move(inner)) {}

  double dt() const override { return inner_->dt(); }
  void advance(std::span<double> states, const increment_view& noise, piece p) const override {
    inner_->advance(states, noise, p);
  }
  shared_steps share(const increment_view& one_path) const override { return inner_->share(one_path); }
  void advance(std::span<double> states, const shared_steps& noise, std::int64_t first, std::int64_t steps,
               piece p) const override {
    inner_->advance(states, noise, first, steps, p);
  }
  void finish(std::span<double> states) const override { inner_->finish(states); }

 private:
  std::unique_ptr<kernel> inner_;
};

}  // namespace polhode::test
