// SPDX-License-Identifier: Apache-2.0
#include "experiments/stability/mean_square.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algebra/decompositions.hpp"
#include "ensemble/noise/paths.hpp"
#include "problem/vectors.hpp"
#include "sphere/closed_forms/linearised.hpp"
#include "sphere/equilibria.hpp"
#include "transfer/points/noise_nodes.hpp"

namespace polhode {
namespace {

constexpr int nodes = 24;  // of the noise of a step

double strength_along(const report::scene& s, const Eigen::Vector3d& direction) {
  double square = 0;
  for (const auto& v : noise_vectors_of(s))
    square += std::pow(direction.dot(Eigen::Map<const Eigen::Vector3d>(v.data())), 2);
  return std::sqrt(square);
}

/// One step, every lane with the noise of a node: Jacobians in the plane across the direction.
struct noisy_jacobians {
  std::vector<Eigen::Matrix2d> at;
  std::vector<double> weight;
};

noisy_jacobians jacobians_of(const subject& s, const scheme_entry& scheme, const Eigen::Vector3d& direction,
                             double dt) {
  const auto rule = nodes_of(*s.model, scheme.needs_areas, dt, {nodes, 1});
  const auto layout = s.model->layout();
  const auto channels = static_cast<std::size_t>(layout.channels);
  std::vector<double> dw(layout.increments(1, block_lanes), 0.0), area(layout.areas(1, block_lanes), 0.0);
  for (std::size_t i = 0; i < rule.weight.size(); ++i)
    for (std::size_t k = 0; k < channels; ++k) dw[k * block_lanes + i] = rule.dw[i * channels + k];
  auto states = replicated(s.scene.momentum);
  std::vector<double> tangents(tangent_vectors * states.size(), 0.0);
  const auto frame = tangent_frame(direction);
  const auto entry = [&](int t, int k) -> double* {
    return tangents.data() + static_cast<std::size_t>(t) * states.size() + static_cast<std::size_t>(k) * block_lanes;
  };
  for (int t = 0; t < 2; ++t)
    for (int k = 0; k < 3; ++k) std::fill_n(entry(t, k), block_lanes, frame(k, t));
  scheme.tangent(dt)->advance(states, tangents, {1, dw, area});
  noisy_jacobians out{{}, rule.weight};
  for (std::size_t i = 0; i < rule.weight.size(); ++i) {
    Eigen::Matrix<double, 3, 2> moved;
    for (int t = 0; t < 2; ++t)
      for (int k = 0; k < 3; ++k) moved(k, t) = entry(t, k)[i];
    out.at.emplace_back(frame.transpose() * moved);
  }
  return out;
}

}  // namespace

std::vector<noisy_equilibrium> noisy_equilibria(const subject& s) {
  const auto& p = *s.sphere();
  std::vector<noisy_equilibrium> out;
  if (!p.varying.empty()) return out;  // what is true there is not known
  const auto add = [&](const char* what, std::size_t number, const Eigen::Vector3d& direction) {
    const double strength = strength_along(s.scene, direction);
    if (strength > 0) out.push_back({fmt::format("{} {}", what, number), direction, strength});
  };
  if (p.has_field()) {
    const auto all = equilibria(p);
    for (std::size_t i = 0; i < all.size(); ++i) add("equilibrium", i + 1, all[i].direction);
    return out;
  }
  const Eigen::Matrix3d axes = principal_axes(p);
  for (Eigen::Index k = 0; k < 3; ++k) add("axis", static_cast<std::size_t>(k) + 1, axes.col(k));
  return out;
}

report::scene beside(const report::scene& s, const noisy_equilibrium& e) {
  const auto times = [&](double x) {
    const Eigen::Vector3d v = x * e.direction;
    return std::vector<double>{v[0], v[1], v[2]};
  };
  auto out = with_noise_vectors(s, {times(e.strength)});
  out.momentum = times(length(s.momentum));
  return out;
}

double own_mean_square_growth(const subject& beside, const scheme_entry& scheme, const Eigen::Vector3d& direction,
                              double dt) {
  const auto j = jacobians_of(beside, scheme, direction, dt);
  Eigen::Matrix4d squares = Eigen::Matrix4d::Zero();
  for (std::size_t i = 0; i < j.at.size(); ++i)
    for (int a = 0; a < 2; ++a)
      for (int b = 0; b < 2; ++b) squares.block<2, 2>(2 * a, 2 * b) += j.weight[i] * j.at[i](a, b) * j.at[i];
  if (!squares.allFinite()) return std::nan("");
  return std::log(eigenvalues_of(squares).cwiseAbs().maxCoeff()) / dt;
}

double true_mean_square_growth(const sphere_problem& p, const noisy_equilibrium& e) {
  return mean_square_growth(linearised_about(p, e.direction, e.strength));
}

}  // namespace polhode
