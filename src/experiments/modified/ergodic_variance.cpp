// SPDX-License-Identifier: Apache-2.0
#include "experiments/modified/ergodic_variance.hpp"

#include <algorithm>
#include <cmath>

#include "algebra/decompositions.hpp"
#include "algebra/dense_algebra.hpp"
#include "experiments/laws/true_law.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/harmonics.hpp"

namespace polhode {
namespace {

constexpr int least_degree = 16, more_degrees = 8;

/// int law a b over the sphere, all three in harmonics.
class triple_product {
 public:
  explicit triple_product(int degree)
      : rule_(sphere_quadrature(2 * degree + 2)), values_(harmonics(rule_.points, degree)) {}
  double operator()(const Eigen::VectorXd& law, const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
    const auto at = [&](const Eigen::VectorXd& f) { return (values_.leftCols(f.size()) * f).array().eval(); };
    return (rule_.weights.array() * at(law) * at(a) * at(b)).sum();
  }

 private:
  sphere_rule rule_;
  Eigen::MatrixXd values_;
};

/// f less its mean under the law.
Eigen::VectorXd centred(Eigen::VectorXd f, const Eigen::VectorXd& law) {
  f[0] -= law.dot(f) / law[0];
  return f;
}

Eigen::VectorXd of_equation(const sphere_problem& p, const Eigen::VectorXd& density, const exact_averages& averages,
                            int degree) {
  const sparse_matrix generator = backward_operator(p, degree);
  const auto n = generator.rows() - 1;
  const sparse_matrix relaxing = generator.bottomRightCorner(n, n);
  const Eigen::SparseLU<sparse_matrix> lu(relaxing);
  const triple_product integral(degree);
  Eigen::VectorXd law = Eigen::VectorXd::Zero(n + 1), out(averages.count());
  const auto both = std::min(law.size(), density.size());
  law.head(both) = density.head(both);
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    const auto& f = averages.functions[static_cast<std::size_t>(i)];
    const auto g =
        centred(harmonic_coefficients([&](const Eigen::Vector3d& x) { return f(p.radius * x); }, degree), law);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(n + 1);
    u.tail(n) = lu.solve(Eigen::VectorXd(g.tail(n)));
    out[i] = -2 * integral(law, g, u);
  }
  return out;
}

}  // namespace

exact_averages ergodic_variances(const subject& s, const law_averages& averages) {
  exact_averages out = averages.stationary;
  if (out.count() == 0) return out;
  const auto p = *s.sphere();
  const auto law = true_law(s);
  const int degree = std::max(least_degree, law.degree);
  const Eigen::VectorXd before = of_equation(p, *law.density, averages.stationary, degree);
  out.value = of_equation(p, *law.density, averages.stationary, degree + more_degrees);
  out.uncertainty = 3 * (out.value - before).cwiseAbs() + 1e-13 * out.value;
  out.size = out.value;
  return out;
}

Eigen::MatrixXd sum_of_powers(const transfer_operator& op) {
  const auto n = op.matrix.rows();
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(n, n);
  for (auto block : op.blocks) {
    std::erase(block, 0);  // the constant
    const Eigen::MatrixXd step = op.matrix(block, block);
    out(block, block) = inverse_of(Eigen::MatrixXd::Identity(step.rows(), step.cols()) - step);
  }
  return out.bottomRightCorner(n - 1, n - 1);
}

Eigen::VectorXd ergodic_variances(const exact_averages& averages, const transfer_operator& op,
                                  const Eigen::MatrixXd& forgetting, double dt) {
  Eigen::VectorXd out(averages.count());
  if (out.size() == 0) return out;
  const Eigen::VectorXd law = op.stationary_law().transpose();
  const auto n = op.matrix.rows() - 1;
  const triple_product integral(op.basis.degree());
  for (Eigen::Index i = 0; i < out.size(); ++i) {
    const auto g = centred(op.basis.coefficients(averages.functions[static_cast<std::size_t>(i)]), law);
    Eigen::VectorXd w = Eigen::VectorXd::Zero(n + 1);
    w.tail(n) = forgetting * g.tail(n);
    out[i] = dt * (2 * integral(law, g, w) - integral(law, g, g));
  }
  return out;
}

}  // namespace polhode
