// SPDX-License-Identifier: Apache-2.0
#include "ensemble/orbit_start.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <polhode/noise/normal.hpp>

namespace polhode {
namespace {

constexpr std::uint64_t factors = 4;
constexpr std::uint64_t first_draw = 64;  // before it are those of uniform starts and of tangents

/// exp(c) v by Taylor's series of equal parts, to rounding.
Eigen::VectorXd exponential_of(const Eigen::MatrixXd& c, Eigen::VectorXd v) {
  const int parts = std::max(1, static_cast<int>(std::ceil(c.norm())));
  for (int i = 0; i < parts; ++i) {
    Eigen::VectorXd term = v;
    for (int order = 1; term.norm() > 1e-18 * v.norm(); ++order) {
      term = (c * term / (static_cast<double>(order) * parts)).eval();
      v += term;
    }
  }
  return v;
}

Eigen::VectorXd random_element(Eigen::Index n, std::uint64_t seed, std::uint64_t body, std::uint64_t draw) {
  Eigen::VectorXd xi(n);
  for (Eigen::Index k = 0; k < n; k += 3) {
    const auto three = normals<3>({seed, noise_kind::initial_state, body, draw + static_cast<std::uint64_t>(k / 3)});
    for (int i = 0; i < 3 && k + i < n; ++i) xi[k + i] = std::numbers::sqrt3 * three[i];
  }
  return xi;
}

}  // namespace

orbit_start::orbit_start(const model& m, std::span<const double> momentum)
    : momentum_(Eigen::Map<const Eigen::VectorXd>(momentum.data(), m.dimension())), coadjoint_(coadjoint_matrices(m)) {}

void orbit_start::fill(std::uint64_t seed, std::uint64_t first_body, std::span<double> states) const {
  const auto n = momentum_.size();
  const auto draws = static_cast<std::uint64_t>((n + 2) / 3);
  Eigen::MatrixXd c(n, n);
  for (std::uint64_t lane = 0; lane < block_lanes; ++lane) {
    Eigen::VectorXd mu = momentum_;
    for (std::uint64_t i = 0; i < factors; ++i) {
      const auto xi = random_element(n, seed, first_body + lane, first_draw + i * draws);
      c.setZero();
      for (Eigen::Index k = 0; k < n; ++k) c += xi[k] * coadjoint_[static_cast<std::size_t>(k)];
      mu = exponential_of(c, std::move(mu));
    }
    for (Eigen::Index k = 0; k < n; ++k) states[static_cast<std::size_t>(k) * block_lanes + lane] = mu[k];
  }
}

std::vector<double> orbit_start::block(std::uint64_t seed, std::uint64_t first_body) const {
  std::vector<double> states(static_cast<std::size_t>(momentum_.size()) * block_lanes);
  fill(seed, first_body, states);
  return states;
}

}  // namespace polhode
