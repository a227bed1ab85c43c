// SPDX-License-Identifier: Apache-2.0
// Paths of schemes at all levels of a grid, and of the driven equation, by one noise.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "experiments/common/noise_verdict.hpp"
#include "experiments/common/path_limit.hpp"
#include "experiments/weak/path_controls.hpp"
#include "experiments/weak/twin_chain.hpp"

namespace polhode {

class coupled_levels {
 public:
  /// Room for so many paths. Keeps all but the context by reference as well: schemes and observables.
  coupled_levels(const context&, const std::vector<scheme_entry>&, const std::vector<observable>&, int paths);

  const level_grid& grid() const { return grid_; }
  const std::vector<direction>& directions() const { return driven_.directions; }
  const noise_log& log() const { return log_; }
  double steps_of_a_path() const;  ///< at all levels

  void run_block(int block, std::span<const int> open);

  /// Of the first paths of a scheme, f(X_dt) - f(X) path by path (values are not squares here): of each observable and,
  /// last, of all together (common_error.hpp; resolved: in standard errors).
  std::vector<squared_errors> errors(int scheme, int paths, double resolved) const;
  path_limit limit(int scheme, int paths);
  /// Of the first paths, a number a path whose mean is E[f] as the driven equation has it: of each observable.
  std::vector<squared_errors> truth(int paths) const;
  /// Of the first paths of a scheme, a number a path and level whose mean is E[f(X_dt)], whatever the driven equation.
  squared_errors values(int scheme, std::size_t observable, int paths) const;

 private:
  using level_states = std::vector<std::vector<double>>;  ///< [level], of a block
  struct sample {
    std::vector<squared_errors> differences;  ///< [observable]
    path_record paths;
  };
  struct place {
    std::size_t observable;
    int scheme, first_path, lane;
  };
  void keep(const level_states&, const driven_block& truth, const std::vector<double>& excess, place);

  const context& context_;
  const std::vector<scheme_entry>& schemes_;
  level_grid grid_;
  driven_kernels driven_;
  const std::vector<observable>& observables_;
  std::vector<std::vector<double>> squares_;  ///< f(X)^2, [observable][path]
  std::vector<squared_errors> truth_;         ///< [observable]
  path_controls controls_;
  noise_effect noise_;
  noise_log log_;
  std::vector<std::vector<std::unique_ptr<kernel>>> kernels_;  ///< [scheme][level]
  std::vector<sample> found_;
};

}  // namespace polhode
