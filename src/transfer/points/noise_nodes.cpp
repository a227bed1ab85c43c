#include "transfer/points/noise_nodes.hpp"

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

/// Directions of the space of the active channels, a row each, of equal or of quadrature weight.
struct direction_rule {
  Eigen::MatrixXd at;
  Eigen::VectorXd weights;
};

direction_rule directions_in(int channels) {
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
  const int active = layout.active, areas = with_areas ? layout.active_pairs() : 0;
  const auto directions = directions_in(active);
  const auto radii = radii_of(active);
  noise_nodes out{dt, {}, {}, {}};
  for (Eigen::Index r = 0; r < radii.nodes.size(); ++r)
    for (Eigen::Index d = 0; d < directions.weights.size(); ++d)
      for (int signs = 0; signs < 1 << areas; ++signs) {
        out.weight.push_back(radii.weights[r] * directions.weights[d] / (1 << areas));
        for (int k = 0; k < layout.channels; ++k)
          out.dw.push_back(k < active ? std::sqrt(dt) * radii.nodes[r] * directions.at(d, k) : 0);
        for (int k = 0; with_areas && k < layout.pairs(); ++k)
          out.area.push_back(k >= areas ? 0 : (signs >> k & 1) == 0 ? dt / 2 : -dt / 2);
      }
  return out;
}

double rare_share(int active_channels) {
  return boost::math::gamma_q((active_channels + 2) / 2.0, rare_noise * rare_noise / 2) / 2;
}

noise_nodes nodes_of(const model& m, bool with_areas, double dt, const noise_rule& rule) {
  const auto layout = m.layout();
  const int active = layout.active, areas = with_areas ? layout.active_pairs() : 0;
  const normal_rule hermite(rule.channel), area(rule.area);
  noise_nodes out{dt, {}, {}, {}};
  std::vector<int> at(static_cast<std::size_t>(active + areas), 0);
  const auto axis = [&](int d) -> const normal_rule& { return d < active ? hermite : area; };
  for (bool more = true; more;) {
    double weight = 1;
    for (int d = 0; d < active + areas; ++d) weight *= axis(d).weights[at[static_cast<std::size_t>(d)]];
    if (weight > negligible) {
      out.weight.push_back(weight);
      const auto node = [&](int d) { return axis(d).nodes[at[static_cast<std::size_t>(d)]]; };
      for (int k = 0; k < layout.channels; ++k) out.dw.push_back(k < active ? std::sqrt(dt) * node(k) : 0);
      for (int k = 0; with_areas && k < layout.pairs(); ++k)
        out.area.push_back(k < areas ? dt / 2 * node(active + k) : 0);
    }
    more = false;
    for (int d = 0; d < active + areas && !more; ++d) {
      auto& i = at[static_cast<std::size_t>(d)];
      more = ++i < axis(d).nodes.size();
      if (!more) i = 0;
    }
  }
  return out;
}

}  // namespace polhode
