// SPDX-License-Identifier: Apache-2.0
#include "transfer/transfer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "algebra/dense_algebra.hpp"
#include "problem/noise_covariance.hpp"
#include "problem/vectors.hpp"
#include "transfer/basis/radial_motion.hpp"
#include "transfer/basis_sums.hpp"
#include "transfer/points/half_turns.hpp"
#include "transfer/points/mapped_points.hpp"

namespace polhode {
namespace {

/// Values of T B_j at those points.
Eigen::MatrixXd mapped_basis(const kernel& k, const shell_basis& basis, const points_in_space& points,
                             const noise_nodes& noise) {
  const int size = basis.size();
  Eigen::MatrixXd values(points.rows(), size);
  std::vector<double> sums(static_cast<std::size_t>(size) * block_lanes);
  int done = 0;
  map_points(k, points, noise, [&](int first, int lanes, std::span<const double> weights, const double* states) {
    if (done == 0) std::ranges::fill(sums, 0.0);
    add_basis({basis.degree(), basis.radial(), basis.middle(), basis.half(), basis.recurrence().data(), lanes,
               static_cast<int>(weights.size()), weights.data(), states, sums.data()});
    done += static_cast<int>(weights.size());
    if (done < static_cast<int>(noise.weight.size())) return;
    done = 0;
    for (int j = 0; j < size; ++j)
      for (int lane = 0; lane < lanes; ++lane)
        values(first + lane, j) =
            sums[static_cast<std::size_t>((lane / sum_lanes * size + j) * sum_lanes + lane % sum_lanes)];
  });
  return values;
}

/// At a block of points from all over the basis.
bool shells_turn_half(const kernel& k, const shell_basis& basis, const noise_nodes& noise, int active) {
  const auto& all = basis.points();
  points_in_space some(block_lanes, 3);
  for (Eigen::Index i = 0; i < block_lanes; ++i) some.row(i) = all.row(i * all.rows() / block_lanes);
  std::vector<double> block(3 * block_lanes);
  load_block(some, 0, block.data());
  return commutes_with_half_turns(block, noise, active, [&k](const noise_nodes& nodes) -> block_step {
    return
        [&k, table = k.share(nodes.path())](int node, std::span<double> states) { k.advance(states, table, node, 1); };
  });
}

transfer_operator transfer_on(const kernel& k, shell_basis basis, const noise_nodes& noise, bool by_half_turns) {
  transfer_operator out{std::move(basis), {}, {}};
  const auto& b = out.basis;
  if (by_half_turns) {
    out.matrix = b.coefficients_by_class(mapped_basis(k, b, b.quarter(), noise));
    out.blocks = b.classes();
  } else {
    out.matrix = b.coefficients(mapped_basis(k, b, b.points(), noise));
    auto& all = out.blocks.emplace_back(static_cast<std::size_t>(b.size()));
    std::iota(all.begin(), all.end(), 0);
  }
  if (!out.matrix.col(0).hasNaN()) out.matrix.col(0) = Eigen::VectorXd::Unit(out.matrix.rows(), 0);  // T 1 = 1
  return out;
}

/// law T^steps, one row.
Eigen::MatrixXd law_after_steps(Eigen::MatrixXd law, Eigen::MatrixXd power, std::int64_t steps) {
  Eigen::MatrixXd next(law.rows(), law.cols());
  const auto take = [&] {
    next.setZero();
    add_product(law, power, next);
    law.swap(next);
  };
  for (; steps > power.rows(); steps /= 2) {  // squaring costs less than so many steps
    if (steps % 2 == 1) take();
    Eigen::MatrixXd square = Eigen::MatrixXd::Zero(power.rows(), power.cols());
    add_product(power, power, square);
    power.swap(square);
  }
  for (; steps > 0; --steps) take();
  return law;
}

}  // namespace

Eigen::RowVectorXd transfer_operator::law_after(const Eigen::Vector3d& start, std::int64_t steps) const {
  Eigen::RowVectorXd law = basis.at(start);
  for (const auto& block : blocks) law(block) = law_after_steps(law(block), matrix(block, block), steps);
  return law;
}

Eigen::RowVectorXd transfer_operator::stationary_law() const {
  Eigen::RowVectorXd law = Eigen::RowVectorXd::Zero(matrix.rows());
  const auto& own = blocks.front();  // in the others it has nothing, being the only one
  law(own) = invariant_law(matrix(own, own), basis.at(Eigen::Vector3d::UnitZ() * basis.middle())[0]);
  return law;
}

transfer_maker::transfer_maker(const subject& s, const scheme_entry& scheme, double dt, std::int64_t steps)
    : subject_(s), areas_(scheme.needs_areas), dt_(dt), steps_(steps), step_(scheme.make(dt)) {}

transfer_maker::known_noise& transfer_maker::noise_of(const noise_rule& rule) {
  const auto same = std::ranges::find(noise_, rule, &known_noise::rule);
  if (same != noise_.end()) return *same;
  return noise_.emplace_back(rule, nodes_of(*subject_.model, areas_, dt_, rule), std::nullopt);
}

transfer_operator transfer_maker::operator()(const transfer_rule& rule) {
  auto& noise = noise_of(rule.noise);
  shell_basis basis(rule.basis.degree, rule.basis.radial, shell_of(*step_, subject_, noise.nodes, steps_, rule.basis));
  if (!noise.half_turns)
    noise.half_turns = shells_turn_half(*step_, basis, noise.nodes, subject_.model->layout().active);
  return transfer_on(*step_, std::move(basis), noise.nodes, *noise.half_turns);
}

transfer_operator make_transfer(const subject& s, const scheme_entry& scheme, double dt, std::int64_t steps,
                                const transfer_rule& rule) {
  return transfer_maker(s, scheme, dt, steps)(rule);
}

Eigen::VectorXd mean_after_step(const subject& s, const scheme_entry& scheme, double dt, const noise_rule& rule,
                                const points_in_space& points, const sphere_function& f) {
  const auto stepper = scheme.make(dt);
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(points.rows());
  map_each_point(*stepper, points, nodes_of(*s.model, scheme.needs_areas, dt, rule),
                 [&](int point, double weight, const Eigen::Vector3d& after) { mean[point] += weight * f(after); });
  return mean;
}

Eigen::VectorXd change_by_far_noise(const subject& s, const scheme_entry& scheme, double dt, std::int64_t steps,
                                    const std::function<Eigen::VectorXd(const transfer_operator&)>& ask) {
  constexpr noise_rule near{8, 2};
  const basis_rule rule = scheme.info.casimir.exact ? basis_rule{10, 1, 0} : basis_rule{6, 4, 6};
  const auto stepper = scheme.make(dt);
  const auto noise = nodes_of(*s.model, scheme.needs_areas, dt, near);
  const shell_basis basis(rule.degree, rule.radial, shell_of(*stepper, s, noise, steps, rule));
  const auto far = far_nodes_of(*s.model, scheme.needs_areas, dt);
  const int active = s.model->layout().active;
  const auto answer = [&](const noise_nodes& nodes) {
    return ask(transfer_on(*stepper, basis, nodes, shells_turn_half(*stepper, basis, nodes, active)));
  };
  return (answer(far) - answer(noise)).cwiseAbs();
}

}  // namespace polhode
