// SPDX-License-Identifier: Apache-2.0
#include "transfer/points/noise_nodes.hpp"

#include <array>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <numbers>

#include "algebra/decompositions.hpp"
#include "sphere/harmonics/harmonics.hpp"

namespace polhode {
namespace {

constexpr double negligible = 1e-18;  // weight of a node

struct normal_rule_points {
  Eigen::VectorXd nodes, weights;
};

/// Nodes and weights for the standard normal (Golub and Welsch, Math. Comp. 23 (1969) 221).
struct normal_rule : normal_rule_points {
  explicit normal_rule(int n) {
    Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(n, n);
    for (int k = 1; k < n; ++k) jacobi(k, k - 1) = jacobi(k - 1, k) = std::sqrt(k);
    const auto [values, vectors] = symmetric_eigenpairs_of(jacobi);
    nodes = values;
    weights = vectors.row(0).cwiseAbs2();
  }
};

/// A row a point.
struct cubature {
  Eigen::MatrixXd at;
  Eigen::VectorXd weights;
};

cubature product_of(const normal_rule_points& axis, int axes) {
  const auto n = axis.nodes.size();
  const auto count = static_cast<Eigen::Index>(std::llround(std::pow(n, axes)));
  cubature out{Eigen::MatrixXd(count, axes), Eigen::VectorXd::Ones(count)};
  for (Eigen::Index i = 0; i < count; ++i)
    for (Eigen::Index d = 0, rest = i; d < axes; ++d, rest /= n) {
      out.at(i, d) = axis.nodes[rest % n];
      out.weights[i] *= axis.weights[rest % n];
    }
  return out;
}

/// Signs of three normals whose product is given: any two are independent.
cubature half_of_the_signs(int product) {
  cubature out{Eigen::MatrixXd(4, 3), Eigen::VectorXd::Constant(4, 0.25)};
  for (int i = 0; i < 4; ++i) {
    const int first = 1 - i % 2 * 2, second = 1 - i / 2 * 2;
    out.at.row(i) << first, second, product * first * second;
  }
  return out;
}

/// Three normals to degree five: E[1], E[x^2], E[x^4] and E[x^2 y^2] settle the weights and the squares of the radii.
cubature degree_five() {
  cubature out{Eigen::MatrixXd::Zero(14, 3), Eigen::VectorXd(14)};
  out.weights << Eigen::VectorXd::Constant(6, 0.16), Eigen::VectorXd::Constant(8, 0.005);
  for (int i = 0; i < 6; ++i) out.at(i, i / 2) = (1 - i % 2 * 2) * std::sqrt(2.5);
  for (int i = 0; i < 8; ++i)
    for (int d = 0; d < 3; ++d) out.at(6 + i, d) = (1 - (i >> d & 1) * 2) * std::sqrt(5.0);
  return out;
}

/// Standard normals in place of areas. side: of two classes in which increments alternate.
cubature areas_by(int nodes, int areas, Eigen::Index side) {
  if (areas == 3 && nodes == 2) return half_of_the_signs(side % 2 == 0 ? 1 : -1);
  if (areas == 3 && nodes == 3) return degree_five();
  return product_of(normal_rule(nodes), areas);
}

/// Writes a node: standard normals of active channels and areas.
void add_node(noise_nodes& out, const noise_layout& layout, double weight, const Eigen::RowVectorXd& channels,
              const Eigen::RowVectorXd& areas, bool with_areas) {
  if (weight <= negligible) return;
  out.weight.push_back(weight);
  for (int k = 0; k < layout.channels; ++k) out.dw.push_back(k < channels.size() ? std::sqrt(out.dt) * channels[k] : 0);
  for (int k = 0; with_areas && k < layout.pairs(); ++k)
    out.area.push_back(k < areas.size() ? out.dt / 2 * areas[k] : 0);
}

/// Directions of the space of the active channels, of equal or of quadrature weight.
cubature directions_in(int channels) {
  constexpr int degree = 9, angles = 16;
  if (channels == 1) return {Eigen::Vector2d(1, -1), Eigen::Vector2d::Constant(0.5)};
  if (channels == 2) {
    Eigen::MatrixXd at(angles, 2);
    for (int i = 0; i < angles; ++i) {
      const double angle = 2 * std::numbers::pi * i / angles;
      at.row(i) << std::cos(angle), std::sin(angle);
    }
    return {at, Eigen::VectorXd::Constant(angles, 1.0 / angles)};
  }
  const auto rule = sphere_quadrature(degree);
  return {rule.points, rule.weights / rule.weights.sum()};
}

/// Radii of a normal vector and their weights: Gauss-Legendre in panels.
normal_rule_points radii_of(int channels) {
  using rule = boost::math::quadrature::gauss<double, 10>;
  constexpr double panel = 2;
  constexpr int panels = static_cast<int>(farthest_noise / panel), half = 5;
  normal_rule_points out{Eigen::VectorXd(2 * half * panels), Eigen::VectorXd(2 * half * panels)};
  Eigen::Index at = 0;
  for (int i = 0; i < panels; ++i)
    for (std::size_t k = 0; k < half; ++k)
      for (const double side : {-1.0, 1.0}) {
        const double r = panel * (i + 0.5 + 0.5 * side * rule::abscissa()[k]);
        out.nodes[at] = r;
        out.weights[at++] = rule::weights()[k] * std::pow(r, channels - 1) * std::exp(-r * r / 2);
      }
  out.weights /= out.weights.sum();
  return out;
}

}  // namespace

noise_nodes far_nodes_of(const model& m, bool with_areas, double dt) {
  const auto layout = m.layout();
  const int pairs = with_areas ? layout.active_pairs() : 0;
  const auto directions = directions_in(layout.active);
  const auto radii = radii_of(layout.active);
  const std::array areas{areas_by(2, pairs, 0), areas_by(2, pairs, 1)};
  noise_nodes out{dt, {}, {}, {}};
  for (Eigen::Index r = 0; r < radii.nodes.size(); ++r)
    for (Eigen::Index d = 0; d < directions.weights.size(); ++d) {
      const auto& all = areas[static_cast<std::size_t>((r + d) % 2)];
      for (Eigen::Index i = 0; i < all.weights.size(); ++i)
        add_node(out, layout, radii.weights[r] * directions.weights[d] * all.weights[i],
                 radii.nodes[r] * directions.at.row(d), all.at.row(i), with_areas);
    }
  return out;
}

double rare_share(int active_channels) {
  return boost::math::gamma_q((active_channels + 2) / 2.0, rare_noise * rare_noise / 2) / 2;
}

noise_nodes nodes_of(const model& m, bool with_areas, double dt, const noise_rule& rule) {
  const auto layout = m.layout();
  const int pairs = with_areas ? layout.active_pairs() : 0;
  const auto channels = product_of(normal_rule(rule.channel), layout.active);
  const std::array areas{areas_by(rule.area, pairs, 0), areas_by(rule.area, pairs, 1)};
  noise_nodes out{dt, {}, {}, {}};
  for (Eigen::Index k = 0; k < channels.weights.size(); ++k) {
    Eigen::Index side = 0;
    for (Eigen::Index rest = k; rest > 0; rest /= rule.channel) side += rest % rule.channel;
    const auto& all = areas[static_cast<std::size_t>(side % 2)];
    for (Eigen::Index i = 0; i < all.weights.size(); ++i)
      add_node(out, layout, channels.weights[k] * all.weights[i], channels.at.row(k), all.at.row(i), with_areas);
  }
  return out;
}

}  // namespace polhode
