// SPDX-License-Identifier: Apache-2.0
// A scheme's own operator: (T_dt f)(Pi) = E[f(Phi_dt(Pi, dW))], without sampling.
//
// The expectation over one step's noise is a product of Gauss-Hermite rules, each node a step of the laboratory's
// kernel for every point of a quadrature; the result is projected on the functions of shell_basis.hpp: on the sphere
// for schemes that keep it, else on a shell around it. Then law_0 T^n is the law of n steps, its product with the
// coefficients of f is E[f(Pi_n)] without sampling error, and the law that T leaves as it is is the scheme's stationary
// law. What is left is the error of the projection and of the rules (transfer_refine.hpp).
//
// Where a step commutes with the half turns of the body (half_turns.hpp), which is tried out at some points and all
// nodes, the operator is computed from a quarter of the points, block by block.
//
// Areas, where a scheme asks for them: the weak surrogate of ensemble/noise/paths.hpp, independent normals of variance
// dt^2/4. Near a shell functions go on as polynomials of the radius; a path far beyond is taken back (Milstein and
// Tretyakov, SIAM J. Numer. Anal. 43 (2005) 1139; for such schemes the moments themselves need not exist).
#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "problem/subject.hpp"
#include "transfer/basis/shell_basis.hpp"
#include "transfer/basis/transfer_rule.hpp"
#include "transfer/points/noise_nodes.hpp"

namespace polhode {

struct transfer_operator {
  shell_basis basis;
  Eigen::MatrixXd matrix;  ///< T B_j = sum_i matrix(i, j) B_i; not finite where a step of the scheme is not
  std::vector<std::vector<int>> blocks;  ///< functions that the matrix does not mix, the constant in the first

  Eigen::RowVectorXd law_after(const Eigen::Vector3d& start, std::int64_t steps) const;
  /// Of total weight one, as law_after; it is unique where the scheme forgets its start.
  Eigen::RowVectorXd stationary_law() const;
};

/// Makes the operators of one step of one length by several rules: what rests on the noise's rule alone is found once.
class transfer_maker {
 public:
  /// steps: over which the shell is to hold the radius of a scheme that leaves the sphere.
  transfer_maker(const subject&, const scheme_entry&, double dt, std::int64_t steps);
  transfer_operator operator()(const transfer_rule&);

 private:
  /// The nodes of a rule, and whether the step commutes with the half turns at each of them.
  struct known_noise {
    noise_rule rule;
    noise_nodes nodes;
    std::optional<bool> half_turns;
  };
  known_noise& noise_of(const noise_rule&);

  const subject& subject_;
  bool areas_;
  double dt_;
  std::int64_t steps_;
  std::shared_ptr<const kernel> step_;
  std::vector<known_noise> noise_;
};

/// One of them.
transfer_operator make_transfer(const subject&, const scheme_entry&, double dt, std::int64_t steps,
                                const transfer_rule&);

/// E[f(Phi_dt(Pi, dW))] at points (a row each), wherever a step leads.
Eigen::VectorXd mean_after_step(const subject&, const scheme_entry&, double dt, const noise_rule&,
                                const Eigen::Matrix<double, Eigen::Dynamic, 3>& points, const sphere_function& f);

/// By how much the answers of `ask` change when the noise of a step is taken out to 8 sqrt(dt) instead of to the nodes
/// of a Gauss-Hermite rule (both on the coarsest basis). More than the answers' uncertainty: the step is not smooth in
/// its increment, and what the rule says of its law is not true.
Eigen::VectorXd change_by_far_noise(const subject&, const scheme_entry&, double dt, std::int64_t steps,
                                    const std::function<Eigen::VectorXd(const transfer_operator&)>& ask);

}  // namespace polhode
