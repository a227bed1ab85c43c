// SPDX-License-Identifier: Apache-2.0
#include "sphere/harmonics/harmonics.hpp"

#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <numbers>
#include <vector>

namespace polhode {
namespace {

// z Y_lm = up(l + 1, m) Y_{l+1,m} + up(l, m) Y_{l-1,m}
double up(int l, int m) { return std::sqrt((l * l - m * m) / (4.0 * l * l - 1)); }

// |J_+ |l m>| / |l m+1>
double ladder(int l, int m) { return std::sqrt(l * (l + 1.0) - m * (m + 1.0)); }

/// P_mm over sin P_{m-1,m-1}.
double highest_ratio(int m) { return std::sqrt((2 * m + 1.0) / (2 * m)) * (m == 1 ? std::numbers::sqrt2 : 1); }

/// At the k-th of n angles, [k][degree + m]: cos(m phi) for m >= 0, sin(|m| phi) for m < 0.
Eigen::MatrixXd waves_on_a_ring(int n, int degree) {
  Eigen::MatrixXd out(n, 2 * degree + 1);
  for (int k = 0; k < n; ++k)
    for (int m = 0; m <= degree; ++m) {
      const double angle = 2 * std::numbers::pi * ((k * m) % n) / n;
      out(k, degree - m) = std::sin(angle);
      out(k, degree + m) = std::cos(angle);
    }
  return out;
}

// L_1 C_m = (ladder(m) S_{m+1} + ladder(m-1) S_{m-1}) / 2, C_m the cosines, S_m the sines; S_0 = 0 and C_0 weighs
// sqrt 2.
sparse_matrix first_generator(int degree) {
  sparse_entries entries;
  const auto add = [&](int row, int column, double value) {
    entries.emplace_back(row, column, value);
    entries.emplace_back(column, row, -value);
  };
  for (int l = 1; l <= degree; ++l)
    for (int m = 0; m <= l; ++m) {
      const int cosine = harmonic_index(l, m);
      if (m < l) add(harmonic_index(l, -(m + 1)), cosine, ladder(l, m) / (m == 0 ? std::numbers::sqrt2 : 2));
      if (m > 1) add(harmonic_index(l, -(m - 1)), cosine, ladder(l, m - 1) / 2);
    }
  return sparse_from(harmonic_count(degree), entries);
}

sparse_matrix third_generator(int degree) {
  sparse_entries entries;
  for (int l = 1; l <= degree; ++l)
    for (int m = -l; m <= l; ++m)
      if (m != 0) entries.emplace_back(harmonic_index(l, -m), harmonic_index(l, m), -m);
  return sparse_from(harmonic_count(degree), entries);
}

}  // namespace

sparse_matrix sparse_from(int size, const sparse_entries& entries) {
  sparse_matrix a(size, size);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

Eigen::MatrixXd harmonics(const points_on_sphere& x, int degree) {
  const Eigen::ArrayXd z = x.col(2);
  Eigen::MatrixXd out(x.rows(), harmonic_count(degree));
  Eigen::ArrayXd cosine = Eigen::ArrayXd::Ones(x.rows()),
                 sine = Eigen::ArrayXd::Zero(x.rows());  // of m phi, times sin^m
  double highest = std::sqrt(0.25 / std::numbers::pi);   // of P_mm, over sin^m
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) {
      const Eigen::ArrayXd turned = cosine * x.col(0).array() - sine * x.col(1).array();
      sine = cosine * x.col(1).array() + sine * x.col(0).array();
      cosine = turned;
      highest *= highest_ratio(m);
    }
    Eigen::ArrayXd before = Eigen::ArrayXd::Zero(x.rows()), p = Eigen::ArrayXd::Constant(x.rows(), highest);
    for (int l = m; l <= degree; ++l) {
      out.col(harmonic_index(l, m)) = cosine * p;
      if (m > 0) out.col(harmonic_index(l, -m)) = sine * p;
      const Eigen::ArrayXd next = (z * p - (l > m ? up(l, m) : 0) * before) / up(l + 1, m);
      before = p;
      p = next;
    }
  }
  return out;
}

Eigen::VectorXd harmonics_at(const Eigen::Vector3d& x, int degree) {
  return harmonics(x.transpose(), degree).transpose();
}

sphere_rule sphere_quadrature(int degree) {
  const int rings = degree / 2 + 1, per_ring = degree + 1;
  sphere_rule rule{points_on_sphere(rings * per_ring, 3), Eigen::VectorXd(rings * per_ring), per_ring};
  int i = 0;
  const auto add_ring = [&](double z) {
    const double radius = std::sqrt((1 - z) * (1 + z)), slope = boost::math::legendre_p_prime(rings, z);
    const double weight = 2 / (radius * radius * slope * slope);
    for (int k = 0; k < per_ring; ++k, ++i) {
      const double phi = 2 * std::numbers::pi * k / per_ring;
      rule.points.row(i) << radius * std::cos(phi), radius * std::sin(phi), z;
      rule.weights[i] = weight * 2 * std::numbers::pi / per_ring;
    }
  };
  for (const double z : boost::math::legendre_p_zeros<double>(rings)) {  // those >= 0; GSL's tables have 1e-11 only
    add_ring(z);
    if (z != 0) add_ring(-z);
  }
  return rule;
}

// Ring by ring the waves in phi first, then the sums over the rings: as many operations as points times degree.
Eigen::VectorXd harmonic_coefficients(const std::function<double(const Eigen::Vector3d& x)>& f, int degree) {
  const sphere_rule rule = sphere_quadrature(2 * degree + 2);
  const Eigen::Index rings = rule.weights.size() / rule.per_ring;
  Eigen::MatrixXd values(rings, rule.per_ring);
  for (Eigen::Index i = 0; i < rule.weights.size(); ++i)
    values(i / rule.per_ring, i % rule.per_ring) = rule.weights[i] * f(rule.points.row(i).transpose());
  const Eigen::MatrixXd waves = values * waves_on_a_ring(rule.per_ring, degree);
  const Eigen::ArrayXd z = rule.points(Eigen::seqN(0, rings, rule.per_ring), 2), radius = ((1 - z) * (1 + z)).sqrt();
  Eigen::VectorXd out(harmonic_count(degree));
  Eigen::ArrayXd highest = Eigen::ArrayXd::Constant(rings, std::sqrt(0.25 / std::numbers::pi));  // P_mm
  for (int m = 0; m <= degree; ++m) {
    if (m > 0) highest *= radius * highest_ratio(m);
    Eigen::ArrayXd before = Eigen::ArrayXd::Zero(rings), p = highest;
    for (int l = m; l <= degree; ++l) {
      out[harmonic_index(l, m)] = waves.col(degree + m).dot(p.matrix());
      if (m > 0) out[harmonic_index(l, -m)] = waves.col(degree - m).dot(p.matrix());
      const Eigen::ArrayXd next = (z * p - (l > m ? up(l, m) : 0) * before) / up(l + 1, m);
      before = p;
      p = next;
    }
  }
  return out;
}

std::array<sparse_matrix, 3> rotation_generators(int degree) {
  std::array<sparse_matrix, 3> l;
  l[0] = first_generator(degree);
  l[2] = third_generator(degree);
  l[1] = sparse_matrix(l[0] * l[2]) - sparse_matrix(l[2] * l[0]);  // [L_3, L_1] = -L_2
  return l;
}

std::array<sparse_matrix, 3> coordinates(int degree) {
  sparse_entries entries;
  for (int l = 1; l <= degree; ++l)
    for (int m = 1 - l; m < l; ++m) {
      entries.emplace_back(harmonic_index(l, m), harmonic_index(l - 1, m), up(l, m));
      entries.emplace_back(harmonic_index(l - 1, m), harmonic_index(l, m), up(l, m));
    }
  const auto l = rotation_generators(degree);
  std::array<sparse_matrix, 3> x;
  x[2] = sparse_from(harmonic_count(degree), entries);  // the others turn from it: [L_i, x_j] = eps_ikj x_k
  x[0] = sparse_matrix(x[2] * l[1]) - sparse_matrix(l[1] * x[2]);
  x[1] = sparse_matrix(l[0] * x[2]) - sparse_matrix(x[2] * l[0]);
  return x;
}

}  // namespace polhode
