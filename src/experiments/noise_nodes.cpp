#include "experiments/noise_nodes.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace polhode {
namespace {

constexpr double negligible = 1e-18;  // weight of a node

/// Nodes and weights for the standard normal (Golub and Welsch, Math. Comp. 23 (1969) 221).
struct normal_rule {
  Eigen::VectorXd nodes, weights;
  explicit normal_rule(int n) {
    Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(n, n);
    for (int k = 1; k < n; ++k) jacobi(k, k - 1) = jacobi(k - 1, k) = std::sqrt(k);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(jacobi);
    nodes = eigen.eigenvalues();
    weights = eigen.eigenvectors().row(0).cwiseAbs2();
  }
};

}  // namespace

noise_nodes nodes_of(const model& m, bool with_areas, double dt, const noise_rule& rule) {
  const int channels = m.channels(), active = m.active_channels(), pairs = channels * (channels - 1) / 2;
  const int areas = with_areas && active > 1 ? pairs : 0;
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
      for (int k = 0; k < channels; ++k) out.dw.push_back(k < active ? std::sqrt(dt) * node(k) : 0);
      for (int k = 0; with_areas && k < pairs; ++k) out.area.push_back(k < areas ? dt / 2 * node(active + k) : 0);
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
