// SPDX-License-Identifier: Apache-2.0
// Are the numbers that drove a run what was asked for: independent increments N(0, dt), and areas of their law?
//
// Every sum below has mean 0 and a known variance under that law, so that divided by its standard deviation it is
// N(0, 1) for the many thousand numbers of a run. With z an increment over sqrt(dt):
//   every step:      z and z^2 - 1;  u and u^2 - E u^2 of the areas, u = A / (dt/2)
//   two steps in 16 (of one path common to many bodies, two times 64 in four times 64):
//                    z^3 - 3z, z^4 - 6z^2 + 3, |z| > 4 (Poisson); products of channels, of a step and the next, of lane
//                    i and lane i + 1, of lane i and lane i + 32; of areas with increments and with each other
//   a block's first: products with the first of the blocks 1, 2, 4, 8 … before
//   paths:           whether two of them start alike, and the products of any two lanes (path_audit.hpp)
// The first two are Hermite polynomials (orthogonal to what comes before them). A square's deviate is that of its
// chi-square (Wilson, Hilferty, Proc. Natl. Acad. Sci. 17 (1931) 684-688); a sum of so few numbers that it is not
// normal as far out as the threshold is left out.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "statistics/noise/path_audit.hpp"

namespace polhode {

/// [step][row][lane] with block_lanes lanes, rows of which the first `channels` (of `pairs`: all) are drawn.
struct audited_steps {
  int steps = 0, rows = 0, pair_rows = 0;
  std::span<const double> dw;      ///< either these
  std::span<const float> singles;  ///< or these, in units of sqrt(dt)
  std::span<const double> area;
  double dt = 0;
};

/// One deviation from the law, as the normal deviate of its two-sided probability with the sign of the sum.
struct noise_deviation {
  std::string what;
  double z = 0;
  bool of_area = false;
};

class noise_audit {
 public:
  static constexpr int lanes = path_audit::lanes;

  /// pairs: 0 where no areas are drawn. cells: of which areas are made by Chen's relation, 0: normal surrogates.
  noise_audit(int channels, int pairs, int cells = 0);

  /// Consecutive steps of a block, even their number where chunks follow each other.
  void add(const audited_steps&);
  /// Steps of one path, [step][row], the lane-th of its block.
  void add_path(const audited_steps&, int lane);

  /// Blocks in their order.
  void merge(const noise_audit& next);
  /// Other paths of the same block, each heard by add_path alone.
  void join(const noise_audit& paths);

  std::vector<noise_deviation> deviations() const;
  double increments() const { return all_; }
  double areas() const { return area_all_; }

 private:
  using row = path_audit::row;
  static constexpr double tail = 4;                             ///< standard deviations
  static double lanes_apart(const row& z, Eigen::Index apart);  ///< the sum of their products
  struct sums {
    Eigen::ArrayXd mean, square, skew, kurtosis, tail, next_step, next_lane, far_lane;  ///< [channel]
    Eigen::ArrayXd channels;                                                            ///< [channel pair]
    Eigen::ArrayXd area, area_square;                                                   ///< [pair]
    Eigen::ArrayXd area_increment, areas;  ///< [pair x channel], [pairs of pairs]
  };
  template <class Real>
  void add_rows(const audited_steps&, const Real* dw, double unit);
  void look_closely(const std::vector<row>& z, const std::vector<row>* before, const std::vector<row>& u);
  void add_areas(const row& u, int pair);
  void add_sums(const noise_audit&);

  /// A sum over so many numbers, of this variance each; left out where they are fewer than `least`.
  struct summed {
    double sum, numbers, variance, least;
  };
  using listed = std::function<void(const std::string& what, const summed&)>;
  void add_area_deviations(const listed&) const;
  void compare_heads(std::vector<noise_deviation>&) const;
  void compare_paths(std::vector<noise_deviation>&) const;

  int channels_, pairs_, cells_;
  bool paths_ = false;
  sums sums_;
  path_audit path_audit_;
  double all_ = 0, close_ = 0, followed_ = 0, area_all_ = 0, area_close_ = 0;  ///< numbers a channel or pair
  std::vector<std::vector<row>> heads_;                                        ///< [block][channel]: its first step
};

/// Probability with which healthy noise is refuted, over all deviations of a run.
inline constexpr double audit_false_alarm = 1e-6;
/// What |z| of one of so many deviations must exceed.
double audit_threshold(std::size_t deviations);

}  // namespace polhode
