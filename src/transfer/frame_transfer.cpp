// SPDX-License-Identifier: Apache-2.0
#include "transfer/frame_transfer.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <memory>

#include "algebra/dense_algebra.hpp"
#include "problem/vectors.hpp"
#include "transfer/points/half_turns.hpp"
#include "transfer/points/point_block.hpp"

namespace polhode {
namespace {

constexpr std::size_t vector_size = 3 * block_lanes, tangents_size = tangent_vectors * vector_size;
constexpr std::size_t chunk = 32;  // nodes

/// Every lane of a block takes the node's step.
class noise_for_all_lanes {
 public:
  explicit noise_for_all_lanes(const noise_nodes& nodes) : nodes_(nodes) {}
  increment_view operator()(std::size_t node) {
    return {1, replicated_node(nodes_.dw, node, dw_), replicated_node(nodes_.area, node, area_)};
  }

 private:
  std::span<const double> replicated_node(const std::vector<double>& all, std::size_t node, std::vector<double>& to) {
    const auto count = all.size() / nodes_.weight.size();
    to.clear();
    for (const double value : std::span(all).subspan(node * count, count)) to.insert(to.end(), block_lanes, value);
    return to;
  }

  const noise_nodes& nodes_;
  std::vector<double> dw_, area_;
};

Eigen::Vector3d lane_at(const double* block, int lane) {
  return {block[lane], block[block_lanes + lane], block[2 * block_lanes + lane]};
}

/// log of the area that the mapped tangents span.
double log_area(const double* tangents, int lane) {
  return std::log(lane_at(tangents, lane).cross(lane_at(tangents + vector_size, lane)).norm());
}

/// What one step makes of all directions at a block of points.
class mapped_block {
 public:
  mapped_block(const frame_basis& basis, double radius, int first)
      : states_(vector_size), tangents_(tangents_size), points_(lanes_in_use(basis.points(), first)) {
    load_block(basis.points(), first, states_.data());
    for (double& x : states_) x *= radius;
    load_block(basis.first_tangents(), first, tangents_.data());
    load_block(basis.second_tangents(), first, tangents_.data() + vector_size);
  }

  /// E[log |det D Phi|] of each point; the rest into `means`.
  Eigen::VectorXd map(const tangent_kernel& k, const noise_nodes& nodes, frame_means& means) const {
    Eigen::VectorXd area = Eigen::VectorXd::Zero(points_);
    noise_for_all_lanes noise(nodes);
    std::vector<double> states(chunk * vector_size), tangents(chunk * tangents_size);
    for (std::size_t first = 0; first < nodes.weight.size(); first += chunk) {
      const auto weights = std::span(nodes.weight).subspan(first, std::min(chunk, nodes.weight.size() - first));
      for (std::size_t i = 0; i < weights.size(); ++i) {
        const std::span state(states.data() + i * vector_size, vector_size),
            tangent(tangents.data() + i * tangents_size, tangents_size);
        std::ranges::copy(states_, state.begin());
        std::ranges::copy(tangents_, tangent.begin());
        k.advance(state, tangent, noise(first + i));
        for (int lane = 0; lane < points_; ++lane) area[lane] += weights[i] * log_area(tangent.data(), lane);
      }
      means.add(points_, weights, states.data(), tangents.data());
    }
    return area;
  }
  int points() const { return points_; }

 private:
  std::vector<double> states_, tangents_;
  int points_;
};

/// At a block of points from all over the basis.
bool frames_turn_half(const tangent_kernel& k, const frame_basis& basis, double radius, const noise_nodes& nodes,
                      int active) {
  const auto spread = [&](const points_on_sphere& all) {
    points_in_space some(block_lanes, 3);
    for (Eigen::Index i = 0; i < block_lanes; ++i) some.row(i) = all.row(i * all.rows() / block_lanes);
    return some;
  };
  std::vector<double> vectors(vector_size + tangents_size);
  load_block(radius * spread(basis.points()), 0, vectors.data());
  load_block(spread(basis.first_tangents()), 0, vectors.data() + vector_size);
  load_block(spread(basis.second_tangents()), 0, vectors.data() + 2 * vector_size);
  return commutes_with_half_turns(vectors, nodes, active, [&k](const noise_nodes& some) -> block_step {
    return [&k, some](int node, std::span<double> all) {
      k.advance(all.first(vector_size), all.subspan(vector_size), noise_for_all_lanes(some)(std::size_t(node)));
    };
  });
}

/// What one step of one length makes of tangent directions.
struct tangent_step {
  std::unique_ptr<tangent_kernel> stepper;
  noise_nodes nodes;
  double radius;
};

tangent_step step_of(const subject& s, const scheme_entry& scheme, double dt, const transfer_rule& rule) {
  return {scheme.tangent(dt), nodes_of(*s.model, scheme.needs_areas, dt, rule.noise), length(s.scene.momentum)};
}

frame_transfer on_basis(const tangent_step& step, const frame_basis& basis) {
  const int size = basis.size();
  const auto angles = static_cast<std::size_t>(basis.angles());
  frame_means means(basis, basis.turns());
  // Of all functions, and in two columns more of the growths.
  Eigen::MatrixXd found = Eigen::MatrixXd::Zero(size, size + 2);
  std::vector<Eigen::MatrixXd> values(angles);
  for (int first = 0; first < basis.points().rows(); first += block_lanes) {
    const mapped_block block(basis, step.radius, first);
    means.clear();
    const auto area = block.map(*step.stepper, step.nodes, means);
    for (std::size_t i = 0; i < angles; ++i) {
      const int angle = static_cast<int>(i);
      values[i].resize(block.points(), size + 2);
      values[i] << means.functions(angle, block.points()), means.growth(angle, block.points()), area;
    }
    basis.add_coefficients(first, values, found);
  }
  if (!found.hasNaN()) found.col(0) = Eigen::VectorXd::Unit(size, 0);  // T 1 = 1
  return {step.nodes.dt, found.leftCols(size), found.col(size), found.col(size + 1)};
}

}  // namespace

Eigen::Vector2d frame_transfer::exponents() const {
  const auto law = invariant_law(matrix, 1);
  return Eigen::Vector2d(law.dot(length_growth), law.dot(area_growth)) / dt;
}

frame_transfer make_frame_transfer(const subject& s, const scheme_entry& scheme, double dt, const transfer_rule& rule) {
  return on_basis(step_of(s, scheme, dt, rule), frame_basis(rule.basis.degree));
}

Eigen::Vector2d discretisation_exponents(const subject& s, const scheme_entry& scheme, double dt,
                                         const transfer_rule& rule) {
  const auto step = step_of(s, scheme, dt, rule);
  const frame_basis invariant(rule.basis.degree, frame_basis::functions::invariant);
  if (frames_turn_half(*step.stepper, invariant, step.radius, step.nodes, s.model->layout().active))
    return on_basis(step, invariant).exponents();
  return on_basis(step, frame_basis(rule.basis.degree)).exponents();
}

}  // namespace polhode
