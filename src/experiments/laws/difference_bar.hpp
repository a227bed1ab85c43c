// SPDX-License-Identifier: Apache-2.0
// How far the difference of two stationary laws is known at a degree: the law that a step leaves as it is, and the
// equation's own, both projected on harmonics.
//
// Let A = T - 1, T the step's operator on degree N, B the generator on degree N, a A = 0 and b B = 0 their laws. On a
// lower degree M < N solve Poisson's equations A_M u = f - a_M(f) and B_M v = f - b_M(f). Their remainders in the
// degrees M + 1, …, N,
//
//   r = f - a_M(f) - A u,   s = f - b_M(f) - B v,
//
// are known, and as a A = 0 and b B = 0, exactly
//
//   (a - b)(f) - (a_M - b_M)(f) = a(r) - b(s) = (a - b)(s) + a(r - s):
//
// the bias at the lower degree lacks what the two laws differ by, on the generator's remainder, and the law of what the
// two remainders differ by. Both are small of the bias' own order in dt (Mattingly, Stuart and Tretyakov, SIAM J.
// Numer. Anal. 48 (2010) 552, with remainders of a projection in place of those of a step). In absolute values, degree
// by degree,
//
//   bar = sum over l of |s_l| |(a - b)_l| + |r_l - s_l| |a_l|,
//
// no sign is left to chance: the bar is at least what the bias changes by from M to N, and as large where that change
// is small by accident. With the exact laws for weights it would bound the error at M (dual weighted residuals: Becker
// and Rannacher, Acta Numerica 10 (2001) 1); it is taken for the answer at N, which is nearer. What it rests on: that
// beyond N less follows than lies between M and N.
#pragma once

#include <Eigen/Core>

#include "sphere/harmonics/harmonics.hpp"

namespace polhode {

/// What is known of the generator on one degree: it takes as much for every scheme.
struct projected_generator {
  Eigen::RowVectorXd law;     ///< of total weight one: its product with the coefficients of f is E[f]
  Eigen::MatrixXd remainder;  ///< s, a column a function: nothing up to the lower degree
};

/// The lower degree M that goes with N: four less, and not below the least that holds an observable.
int lower_degree(int degree);

/// functions: coefficients up to the degree, a column each. Empty law where the generator is singular.
projected_generator project_generator(const sparse_matrix& generator, const Eigen::MatrixXd& functions);

/// step: T, of as many functions as the generator, whose law is known. law: a. One bar a function.
Eigen::VectorXd difference_bar(const Eigen::MatrixXd& step, const Eigen::RowVectorXd& law, const projected_generator&,
                               const Eigen::MatrixXd& functions);

}  // namespace polhode
