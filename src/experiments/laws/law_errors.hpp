// SPDX-License-Identifier: Apache-2.0
// The errors of a scheme's law in every observable, each in its own size: after a time and at all times up to it, and
// at equilibrium. What the choice of an integrator and the tables of cost rest on.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sphere/expectations/expectation_curve.hpp"
#include "transfer/transfer_refine.hpp"

namespace polhode {

/// energy, pi1, …, exp(pi3), casimir; size: root of the mean square over the sphere.
struct law_observables {
  std::vector<std::string> names;
  std::vector<sphere_function> functions;
  Eigen::VectorXd size;

  Eigen::Index count() const { return size.size(); }
};
law_observables every_observable(const subject&);

/// Of one observable: its largest error, with what is uncertain of it, and when that is.
struct observable_error {
  std::string observable;
  double value = 0, uncertainty = 0;  ///< in units of the observable's size
  double time = 0;                    ///< none at equilibrium

  double bound() const { return value + uncertainty; }
};

/// The errors of one scheme at one dt, [observable + count() * time], in units of the observable's size.
struct law_error {
  Eigen::VectorXd error, uncertainty;
  std::vector<double> times;

  std::vector<observable_error> worst_in_time(const law_observables&) const;
};

/// E[f_i(X)] of an operator after these numbers of steps, increasing: [function][time].
Eigen::MatrixXd means_after(const transfer_operator&, const Eigen::Vector3d& start, std::span<const sphere_function>,
                            const std::vector<std::int64_t>& after);

/// E[f(Pi_t)] - E[f(X_t)] after every step up to the horizon; of more than `most_times` steps as many are looked at,
/// the last among them.
class weak_law {
 public:
  static constexpr std::int64_t most_times = 512;

  /// accuracy: of the truth, in units of each observable's size. kept: as for refine.
  weak_law(const subject&, double horizon, double accuracy, operator_store* kept = nullptr);

  const law_observables& observables() const { return observables_; }
  const expectation_curve& truth() const { return truth_; }
  double horizon() const { return horizon_; }

  /// finer: looks at the times of dt * finer, so that runs of several dt can be combined. tolerance: of each error, or
  /// of a tenth of the largest.
  law_error error(const scheme_entry&, double dt, double tolerance, std::int64_t finer = 1) const;

 private:
  const subject& subject_;
  double horizon_;
  law_observables observables_;
  Eigen::Vector3d start_;
  expectation_curve truth_;
  operator_store* kept_;
};

/// The same of the stationary laws of schemes that keep the sphere.
class equilibrium_law {
 public:
  equilibrium_law(const subject&, double accuracy, operator_store* kept = nullptr);

  const law_observables& observables() const { return observables_; }
  const Eigen::VectorXd& mean() const { return mean_; }
  const Eigen::VectorXd& uncertainty() const { return uncertainty_; }
  const std::string& reason() const { return reason_; }  ///< why the truth is not known; empty: it is

  law_error error(const scheme_entry&, double dt, double tolerance) const;

 private:
  const subject& subject_;
  law_observables observables_;
  Eigen::VectorXd mean_, uncertainty_;
  std::string reason_;
  operator_store* kept_;
};

}  // namespace polhode
