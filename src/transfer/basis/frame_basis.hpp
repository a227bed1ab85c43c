// SPDX-License-Identifier: Apache-2.0
// Functions of a state on the sphere and a tangent direction at it, a direction and its opposite being the same.
//
// Such a pair is a rotation R = (v, w, x), w = x cross v. Its functions are the Wigner functions of even right index:
// with Euler angles alpha, beta, gamma about z, y, z, so that gamma turns v about x,
//
//   F = sqrt(2l+1) d^l_mn(beta) {1 for m = n = 0, else sqrt(2) cos(m alpha + n gamma), sqrt(2) sin(m alpha + n gamma)},
//   n = 0, 2, ... <= l;  m = 0 ... l for n = 0, else -l ... l,
//
// orthonormal under the uniform law. They come in the order n, m, l, cosine before sine; the first one is 1.
//
// Half turns of the body (half_turns.hpp) take R to g R: about axis 3 F changes by (-1)^m; about axis 1 alpha, beta,
// gamma become -alpha, pi - beta, gamma + pi, and F of (l, m, n) becomes (-1)^(l - max(|m|, n)) times F of (l, -m, n),
// with another sign yet for sines of n = 0. Those that all half turns leave as they are: of even m, (F + F after the
// half turn about axis 1), normalised. A law that is the only one is known by them alone, and they by a quarter of the
// points.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <vector>

#include "sphere/harmonics/harmonics.hpp"

namespace polhode {

class frame_basis {
 public:
  enum class functions { all, invariant };  ///< invariant: under all half turns
  explicit frame_basis(int degree, functions = functions::all);

  int degree() const { return degree_; }
  int size() const { return first_.back(); }
  /// Of the sums over all F of some m (transfer/frame_sums.hpp), of which the functions are combinations.
  int summed() const { return summed_; }
  int m_step() const { return which_ == functions::all ? 1 : 2; }
  /// Columns of values of all F that are summed into columns of values of the functions.
  Eigen::MatrixXd combined(const Eigen::MatrixXd& values) const;

  /// For each n and m, with L = max(|m|, n): F of degree L over |cos(beta/2)|^|m+n| |sin(beta/2)|^|m-n| and the cosine;
  /// then for l = L ... degree the factors of p_{l+1} = (first cos(beta) + second) p_l - third p_{l-1}
  /// (transfer/frame_sums.hpp).
  const std::vector<double>& recurrence() const { return recurrence_; }

  /// Where functions are known by their values: at each point, the directions v cos(gamma) + w sin(gamma).
  const points_on_sphere& points() const { return points_; }
  const points_on_sphere& first_tangents() const { return v_; }
  const points_on_sphere& second_tangents() const { return w_; }
  int angles() const { return degree_ + 1; }
  const std::vector<double>& turns() const { return turns_; }  ///< [angle]: cos(gamma), sin(gamma)

  /// Adds to `out` what the points first, first + 1 ... contribute to the coefficients of functions, a column each;
  /// values[angle]: [point][function]. Over all points: exact for functions in the span, of functions as invariant as
  /// they are.
  void add_coefficients(int first, const std::vector<Eigen::MatrixXd>& values, Eigen::MatrixXd& out) const;

 private:
  /// scale (F_one + sign F_other).
  struct combination {
    int one, other;
    double scale, sign;
  };
  void list_functions();
  void make_duals(const Eigen::VectorXd& weights);
  double angle(int i) const;

  int degree_;
  functions which_;
  int summed_ = 0;
  std::vector<combination> combinations_;
  std::vector<int> first_;  // function of each n, and their number
  std::vector<double> recurrence_, turns_;
  points_on_sphere points_, v_, w_;
  /// [n / 2]: functions at gamma = 0 and pi / 2n times the weights of the points, as
  /// F = F(0) cos(n gamma) + F(pi / 2n) sin(n gamma).
  std::vector<std::array<Eigen::MatrixXd, 2>> duals_;
};

/// Means over the noise of one step, for a block of points: of all functions where their directions are mapped to.
class frame_means {
 public:
  /// turns: [angle]: cos(gamma), sin(gamma).
  frame_means(const frame_basis&, std::span<const double> turns);
  void clear();
  /// Of the lanes in use, nodes of a rule: their weights, and the mapped points and tangents as in
  /// transfer/frame_sums.hpp.
  void add(int lanes, std::span<const double> weights, const double* states, const double* tangents);
  /// [point][function] of one angle, for the block's first points.
  Eigen::MatrixXd functions(int angle, int points) const;
  /// E[log |u|] of one angle.
  Eigen::VectorXd growth(int angle, int points) const;

 private:
  const frame_basis& basis_;
  std::span<const double> turns_;
  std::vector<double> sums_, growth_;
};

}  // namespace polhode
