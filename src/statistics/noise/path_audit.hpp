// SPDX-License-Identifier: Apache-2.0
// Are the paths of a run different ones, and independent of each other?
//
// Exactly: the first numbers of all paths, bit for bit. Two fast normals are the same float with a probability of
// q = 2^-23/pi + 2^-32 at most: the sum over all floats of their squared probabilities, their spacing near z being
// 2^-23 |z| at most and that of the quantile's words 2^-32; twice that, as rounding inside the quantile leaves some
// floats to their neighbours. Precise ones are alike far more rarely. So n paths that start with k numbers each have
// two alike with a probability of at most n (n - 1) / 2 q^k.
//
// By their products: for two lanes a < b of a block sum z_a z_b / sqrt(sum z_b^2) is N(0, 1) for any number of terms,
// as it is for every z_b. The largest of all 2016 pairs, its probability times their number (Bonferroni).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <numbers>
#include <vector>

namespace polhode {

class path_audit {
 public:
  static constexpr int lanes = 64;
  static constexpr int start_steps = 4;      ///< that the start of a path has, or fewer
  static constexpr int compared_every = 64;  ///< steps: one number of a lane is multiplied with those of the others
  static constexpr double same_number = 0x1p-23 / std::numbers::pi + 0x1p-32;  ///< q
  using row = Eigen::Array<double, lanes, 1>;

  /// The first steps of 64 paths, [step][row][lane], of which the first `channels` rows are drawn.
  template <class Real>
  void add_starts(const Real* z, int steps, int rows, int channels);
  /// The first steps of one path, [step][row].
  void add_start(const double* z, int steps, int rows, int channels);
  /// Standard normals of the lanes of a block.
  void add_products(const row& z);
  void merge(const path_audit&);

  /// Largest probability with which healthy noise has as many paths alike as were found; 1 if there are none.
  double probability_of_repeats() const;
  /// The same of the largest product of two lanes.
  double probability_of_products() const;

 private:
  template <class Real>
  static std::uint64_t key_of(const Real* first, int steps, int rows, int channels, int stride);

  std::vector<std::uint64_t> starts_;  ///< hashes
  int numbers_ = 0;                    ///< of the shortest start
  Eigen::MatrixXd products_;           ///< below the diagonal and on it; empty before the first
};

}  // namespace polhode
