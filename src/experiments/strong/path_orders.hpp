// SPDX-License-Identifier: Apache-2.0
// In what sense does a scheme converge path by path? Besides the mean square at the end of the horizon: in the supremum
// over it, in L^1 and L^4, and almost surely.
//
// Where the order holds in L^p for every p, the error of almost every path is at most a random constant times dt^(order
// - eps), for every eps > 0: Kloeden, Neuenkirch, LMS J. Comput. Math. 10 (2007) 235-253, Lemma 2.1 (Borel-Cantelli).
// So the order claimed has to be seen in each norm, and as the median of the slopes of single paths.
#pragma once

#include "experiments/common/driven_block.hpp"
#include "experiments/common/recorder.hpp"
#include "statistics/orders/order_fit.hpp"

namespace polhode {

/// So often in a step of the coarsest level are errors looked at, at the ends of a level's own steps: the claim is
/// E max_n |X_n - X(t_n)|^2 (Kloeden, Platen, Numerical Solution of SDEs, 1992, section 10.6). The finest level is
/// looked at where the level before it is, so that every kernel is also seen taking more than one step at a call. Of
/// few times a maximum misses a share ~ n^(-1/2) of the supremum, and a slope would be that share's: where the coarsest
/// level of a fit has fewer than 32 steps, all of the fit are looked at where it is.
int looks_in_coarsest(const level_grid&);

/// The largest |X_dt - X|^2 of each path over those times.
struct largest_errors {
  squared_errors squares;
  largest_errors(int paths, int levels)
      : squares{paths, levels, std::vector<double>(static_cast<std::size_t>(paths * levels))} {}
  /// Takes the states of a level through the chunk that `truth` has been advanced through.
  void advance(const kernel&, const driven_block& truth, std::size_t level, int first_path, std::span<double> states);
};

/// What is asked of every norm of one scheme.
struct path_order_question {
  const context& c;
  double claimed;     ///< strong order
  bool claimed_seen;  ///< the mean square error has a term of that order: a steeper slope is the scene's kindness
  std::span<const double> dt;
  const level_grid& grid;
};

/// Measurements, fits and verdicts of one scheme.
void report_path_orders(const path_order_question&, const squared_errors& at_the_end, const squared_errors& largest,
                        recorder&);

}  // namespace polhode
