// SPDX-License-Identifier: Apache-2.0
// Averages of systems that do not live on a sphere: errors with their sampling error, by as many paths as it takes.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "problem/observables.hpp"
#include "selection/goal.hpp"
#include "statistics/orders/squared_errors.hpp"

namespace polhode {

class sampled_averages : public goal {
 public:
  sampled_averages(const context&, const goal_question&);

  error_estimate error(const candidate& c, double dt, std::uint64_t seed) const override {
    return estimate(c, dt, seed, fine);
  }
  error_estimate rough_error(const candidate& c, double dt, std::uint64_t seed) const override {
    return estimate(c, dt, seed, rough);
  }
  int rungs() const override { return 2; }
  double floor() const override { return 1e-8; }
  bool affordable(const candidate& c, double dt) const override;
  std::string dear_check(const candidate&, double dt) const override;

 protected:
  static constexpr double fine = 1.0 / 6, rough = 1.0 / 3;  ///< half-widths, of the tolerance
  static constexpr int first_paths = 512, most_paths = 16'384;

  virtual error_estimate estimate(const candidate&, double dt, std::uint64_t seed, double share) const = 0;
  /// Of one path, in components of steps, and what of that is affordable at one step size.
  virtual double work_of_a_path(double dt) const = 0;
  virtual double affordable_work() const = 0;
  /// Standard deviation of the worst observable's error over paths, in units of its size.
  virtual double deviation(const candidate&, double dt) const = 0;
  /// Whether some candidate's error can be told to this tolerance.
  virtual bool resolves(double tolerance) const = 0;

  double paths_needed(const candidate&, double dt, double tolerance) const;
  bool affordable_at(const candidate&, double dt, double tolerance) const;
  /// Throws input_error with the least of round numbers that `resolves` takes.
  void refuse_unresolved() const;
  /// Paths doubled until the half-width is the share of the tolerance or a tenth of the error; at(paths): all of them.
  error_estimate until_tight(double dt, double share, const std::function<error_estimate(int paths)>& at) const;
  /// Columns: [time][observable]; times: one, of 0, at equilibrium. Of each observable the worst time, and of those
  /// asked for the worst.
  error_estimate worst_of(const squared_errors&, const std::vector<double>& sizes, const std::vector<observable>&,
                          const std::vector<double>& times) const;
  bool asked(const std::string& name) const {
    return question_.observable == all_observables || question_.observable == name;
  }
  std::string asked_in_words() const;

  context context_;
  goal_question question_;
  double rate_;
  std::vector<observable>
      observables_;  ///< energy, components and squares, of a long state the first; the one asked for
};

}  // namespace polhode
