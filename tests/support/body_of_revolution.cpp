// SPDX-License-Identifier: Apache-2.0
#include "support/body_of_revolution.hpp"

#include <algorithm>
#include <complex>
#include <numbers>

#include "algebra/decompositions.hpp"
#include "support/dense.hpp"
#include "support/sphere_collocation.hpp"

namespace polhode::test {
namespace {

class chebyshev_line {
 public:
  using matrix = Eigen::MatrixXcd;

  explicit chebyshev_line(int n) : z(n), derivative(n, n), weights_(n) {
    for (int j = 0; j < n; ++j) {
      const double angle = (2 * j + 1) * std::numbers::pi / (2 * n);
      z[j] = std::cos(angle);
      weights_[j] = (j % 2 == 0 ? 1 : -1) * std::sin(angle);
    }
    for (int j = 0; j < n; ++j) {
      double row = 0;
      for (int k = 0; k < n; ++k) {
        if (k == j) continue;
        const double apart = -2 * std::sin((2 * (j + k) + 2) * std::numbers::pi / (4 * n)) *
                             std::sin(2 * (j - k) * std::numbers::pi / (4 * n));  // z_j - z_k
        row += derivative(j, k) = weights_[k] / weights_[j] / apart;
      }
      derivative(j, j) = -row;
    }
  }

  matrix generator(const body_of_revolution& b, int m) const {
    const double d = b.theta * b.c * b.c * (b.k - b.figure), w = b.c * (b.figure - b.k);
    const Eigen::ArrayXd inside = 1 - z.square();
    Eigen::MatrixXd real = (b.across / 2 * inside).matrix().asDiagonal() * (derivative * derivative);
    real += ((d * inside - b.across * (m + 1)) * z).matrix().asDiagonal() * derivative;
    real.diagonal().array() -= b.across / 2 * m * (m + 1) + d * m * z.square() + (b.along - b.across) * m * m / 2;
    matrix out = real.cast<std::complex<double>>();
    out.diagonal() += (std::complex<double>(0, m * w) * z).matrix();
    return out;
  }
  /// The polynomial through values at z_j.
  double at(double x, const Eigen::VectorXd& values) const {
    double above = 0, below = 0;
    for (Eigen::Index j = 0; j < z.size(); ++j) {
      if (x == z[j]) return values[j];
      above += weights_[j] / (x - z[j]) * values[j];
      below += weights_[j] / (x - z[j]);
    }
    return above / below;
  }

  Eigen::ArrayXd z;
  Eigen::MatrixXd derivative;

 private:
  Eigen::ArrayXd weights_;
};

double energy_at(const body_of_revolution& b, double z) { return b.c * b.c / 2 * (b.k + (b.figure - b.k) * z * z); }

}  // namespace

std::optional<body_of_revolution> revolution(const sphere_problem& p) {
  for (int a = 0; a < 3; ++a) {
    const auto i = static_cast<std::size_t>(a), j = (i + 1) % 3, l = (i + 2) % 3;
    const double q = p.covariance(long(j), long(j)), r = p.covariance(a, a);
    Eigen::Matrix3d round = q * Eigen::Matrix3d::Identity();
    round(a, a) = r;
    const auto k = p.quadratic.diagonal();
    if (k[long(j)] == k[long(l)] && p.covariance == round && q > 0)
      return body_of_revolution{a, p.radius, p.damping, k[long(j)], k[long(i)], q, r};
  }
  return std::nullopt;
}

double energy_on_a_line(const body_of_revolution& b, double z, double time, int n) {
  const chebyshev_line line(n);
  const Eigen::MatrixXd a = line.generator(b, 0).real();
  const Eigen::VectorXd f = Eigen::VectorXd::NullaryExpr(n, [&](Eigen::Index j) { return energy_at(b, line.z[j]); });
  return line.at(z, exponential_of(time * a) * f);
}

double gap_on_a_line(const body_of_revolution& b, int n, int most) {
  const chebyshev_line line(n);
  double slowest = HUGE_VAL;
  for (int m = 0; m <= most; ++m) {
    const chebyshev_line::matrix a = line.generator(b, m);
    Eigen::VectorXd rates = eigenvalues_of(m == 0 ? Eigen::MatrixXd(a.real()) : real_form(a)).real();
    std::ranges::sort(rates, std::greater());
    slowest = std::min(slowest, -rates[m == 0 ? 1 : 0]);
  }
  return slowest;
}

double lambda1_on_the_sphere(const body_of_revolution& b, int n) {
  const double d = b.c * (b.figure - b.k), t = b.theta * b.c;
  const auto drift = [=](const Eigen::Vector3d& x) -> Eigen::Vector3d {
    const Eigen::Vector3d turned = Eigen::Vector3d::UnitZ().cross(x);
    return -d * (x[0] * x[0] - t * x[0] * x[1]) * turned + t * d * x[2] * turned.cross(x);
  };
  return sphere_collocation(n, drift, b.across * Eigen::Matrix3d::Identity()).mean([=](const Eigen::Vector3d& x) {
    return -d * x[0] * x[1] + t * d * (x[2] * x[2] - x[0] * x[0]);
  });
}

}  // namespace polhode::test
