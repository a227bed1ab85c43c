// In what sense does a scheme converge path by path? Besides the mean square at the end of the horizon: in the supremum
// over it, in L^1 and L^4, and almost surely.
//
// Where the order holds in L^p for every p, the error of almost every path is at most a random constant times dt^(order
// - eps), for every eps > 0: Kloeden, Neuenkirch, LMS J. Comput. Math. 10 (2007) 235-253, Lemma 2.1 (Borel-Cantelli).
// So the order claimed has to be seen in each norm, and as the median of the slopes of single paths.
#pragma once

#include "experiments/driven_block.hpp"
#include "experiments/judge.hpp"
#include "statistics/order_fit.hpp"

namespace polhode {

/// The largest |X_dt - X|^2 of each path over the end points of the coarsest steps, which all levels share.
struct largest_errors {
  squared_errors squares;
  largest_errors(int paths, int levels)
      : squares{paths, levels, std::vector<double>(static_cast<std::size_t>(paths * levels))} {}
  /// After each chunk; states: [level] of the block that `truth` is advanced to.
  void keep(const std::vector<std::vector<double>>& states, const driven_block& truth, int first_path);
};

/// What is asked of every norm of one scheme.
struct order_question {
  const context& c;
  std::string scheme;
  double claimed;     ///< strong order
  bool claimed_seen;  ///< the mean square error has a term of that order: a steeper slope is the scene's kindness
  std::span<const double> dt;
  int common_times;  ///< over which the supremum is taken
};

/// Measurements, fits and verdicts of one scheme.
void report_path_orders(const order_question&, const squared_errors& at_the_end, const squared_errors& largest,
                        report::results&);

}  // namespace polhode
