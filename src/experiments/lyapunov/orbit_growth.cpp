// SPDX-License-Identifier: Apache-2.0
#include "experiments/lyapunov/orbit_growth.hpp"

#include <algorithm>
#include <cmath>
#include <polhode/noise/normal.hpp>
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

constexpr auto lanes = static_cast<Eigen::Index>(block_lanes);
constexpr std::uint64_t first_draw = 1024;  // behind those of starts

/// One lane of a vector [component][lane].
using lane_of_vector = Eigen::Map<Eigen::VectorXd, 0, Eigen::InnerStride<block_lanes>>;
/// All lanes of it: [lane][component].
using all_lanes = Eigen::Map<Eigen::Array<double, block_lanes, Eigen::Dynamic>>;

all_lanes lanes_of(std::vector<double>& vectors, int which, std::size_t size) {
  return {vectors.data() + static_cast<std::size_t>(which) * size, lanes, static_cast<Eigen::Index>(size) / lanes};
}

}  // namespace

std::unique_ptr<tangent_flow> derivative_flow(std::unique_ptr<tangent_kernel> k) {
  return std::make_unique<derivative>(std::move(k));
}

std::unique_ptr<tangent_flow> neighbour_flow(std::unique_ptr<kernel> k, double distance) {
  return std::make_unique<neighbours>(std::move(k), distance);
}

orbit_block::orbit_block(const orbit_geometry& g, const orbit_start& start, std::uint64_t seed,
                         std::uint64_t first_path, int vectors, bool volume)
    : orbit_block(g, start.block(seed, first_path), seed, first_path, vectors, volume) {}

orbit_block::orbit_block(const orbit_geometry& g, std::vector<double> states, std::uint64_t seed,
                         std::uint64_t first_path, int vectors, bool volume)
    : geometry_(g),
      vectors_(vectors),
      volume_(volume),
      states_(std::move(states)),
      tangents_(states_.size() * static_cast<std::size_t>(vectors)) {
  for (std::uint64_t i = 0; i < tangents_.size(); ++i) {
    const auto lane = i % block_lanes, draw = first_draw + i / block_lanes;
    tangents_[i] = normals<3>({seed, noise_kind::initial_state, first_path + lane, draw})[0];
  }
  project();
  orthonormalise();
  begin();
}

void orbit_block::advance(const tangent_flow& flow, const increment_view& view) {
  flow.advance(states_, tangents_, view);
  if (++chunks_ % projected_at == 0) project();
  orthonormalise();
  const double passed = view.steps * flow.dt();
  time_ += passed;
  if (volume_) follow_divergence(passed);
}

void orbit_block::follow_divergence(double passed) {
  passed_ += passed / 2 * divergence_;
  divergence_ = geometry_.divergences(states_);
  passed_ += passed / 2 * divergence_;
}

orbit_rates orbit_block::read() {
  orbit_rates out{grown_ / time_, {}, {}};
  if (volume_) out.divergence = passed_ / time_;
  if (density_.size() > 0) out.volume = (grown_.rowwise().sum() + log_densities() - density_) / time_;
  begin();
  return out;
}

Eigen::VectorXd orbit_block::state(int lane) const {
  return Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<block_lanes>>(
      states_.data() + lane, static_cast<Eigen::Index>(states_.size()) / lanes);
}

Eigen::VectorXd orbit_block::log_densities() const {
  Eigen::VectorXd out(lanes);
  for (int lane = 0; lane < block_lanes; ++lane) out[lane] = geometry_.log_density(state(lane));
  return out;
}

void orbit_block::project() {
  for (int lane = 0; lane < block_lanes; ++lane) {
    const Eigen::MatrixXd basis = geometry_.tangents(state(lane));
    for (int k = 0; k < vectors_; ++k) {
      lane_of_vector v(tangents_.data() + static_cast<std::size_t>(k) * states_.size() + lane, basis.rows());
      v = (basis * (basis.transpose() * v)).eval();
    }
  }
}

/// Gram and Schmidt, all lanes at once.
void orbit_block::orthonormalise() {
  if (grown_.size() == 0) grown_.setZero(lanes, vectors_);
  for (int k = 0; k < vectors_; ++k) {
    auto v = lanes_of(tangents_, k, states_.size());
    for (int j = 0; j < k; ++j) {
      const auto u = lanes_of(tangents_, j, states_.size());
      const Eigen::Array<double, block_lanes, 1> along = (u * v).rowwise().sum();
      v -= u.colwise() * along;
    }
    const Eigen::Array<double, block_lanes, 1> size = v.square().rowwise().sum().sqrt();
    grown_.col(k).array() += size.log();
    v.colwise() /= size;
  }
}

void orbit_block::begin() {
  time_ = 0;
  grown_.setZero(lanes, vectors_);
  if (!volume_) return;
  if (vectors_ == geometry_.dimension()) density_ = log_densities();
  if (divergence_.size() == 0) divergence_ = geometry_.divergences(states_);
  passed_.setZero(lanes);
}

}  // namespace polhode
