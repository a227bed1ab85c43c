// SPDX-License-Identifier: Apache-2.0
#include "experiments/lyapunov/tangent_flow.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace polhode {
namespace {

class derivative final : public tangent_flow {
 public:
  explicit derivative(std::unique_ptr<tangent_kernel> k) : kernel_(std::move(k)) {}
  double dt() const override { return kernel_->dt(); }
  void advance(std::span<double> states, std::span<double> tangents, const increment_view& view) const override {
    const std::vector<double> start(states.begin(), states.end());
    const auto pair = tangent_vectors * states.size();
    for (std::size_t first = 0; first < tangents.size(); first += pair) {
      std::ranges::copy(start, states.begin());
      kernel_->advance(states, tangents.subspan(first, pair), view);
    }
  }

 private:
  std::unique_ptr<tangent_kernel> kernel_;
};

class neighbours final : public tangent_flow {
 public:
  neighbours(std::unique_ptr<kernel> k, double distance) : kernel_(std::move(k)), distance_(distance) {}
  double dt() const override { return kernel_->dt(); }
  void advance(std::span<double> states, std::span<double> tangents, const increment_view& view) const override {
    const auto size = states.size();
    std::vector<double> moved(tangents.size());
    for (std::size_t i = 0; i < moved.size(); ++i) moved[i] = states[i % size] + distance_ * tangents[i];
    kernel_->advance(states, view);
    for (std::size_t first = 0; first < moved.size(); first += size)
      kernel_->advance(std::span(moved).subspan(first, size), view);
    for (std::size_t i = 0; i < moved.size(); ++i) tangents[i] = (moved[i] - states[i % size]) / distance_;
  }

 private:
  std::unique_ptr<kernel> kernel_;
  double distance_;
};

}  // namespace

std::unique_ptr<tangent_flow> derivative_flow(std::unique_ptr<tangent_kernel> k) {
  return std::make_unique<derivative>(std::move(k));
}

std::unique_ptr<tangent_flow> neighbour_flow(std::unique_ptr<kernel> k, double distance) {
  return std::make_unique<neighbours>(std::move(k), distance);
}

}  // namespace polhode
