// SPDX-License-Identifier: Apache-2.0
#include "support/power_series_in_time.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

namespace polhode::test {
namespace {

using fifty_digits = boost::multiprecision::cpp_bin_float_50;

/// A function on the unit sphere: coefficients of x^a y^b z^c, a + b + c <= degree, c < 2 as z^2 = 1 - x^2 - y^2.
class polynomial {
 public:
  explicit polynomial(int degree) : degree_(degree), c_(std::size_t(2 * (degree + 1) * (degree + 1))) {}
  int degree() const { return degree_; }

  void add(int a, int b, int c, const fifty_digits& value) {
    if (c < 2) {
      c_[index(a, b, c)] += value;
      return;
    }
    add(a, b, c - 2, value);
    add(a + 2, b, c - 2, -value);
    add(a, b + 2, c - 2, -value);
  }
  template <class Visit>
  void each(const Visit& visit) const {
    for (int a = 0; a <= degree_; ++a)
      for (int b = 0; a + b <= degree_; ++b)
        for (int c = 0; c < 2 && a + b + c <= degree_; ++c)
          if (const auto& value = c_[index(a, b, c)]; value != 0) visit(std::array{a, b, c}, value);
  }
  fifty_digits operator()(const Eigen::Vector3d& x) const {
    fifty_digits sum = 0;
    for (int a = degree_; a >= 0; --a) {
      fifty_digits row = 0;
      for (int b = degree_ - a; b >= 0; --b) row = row * x[1] + c_[index(a, b, 0)] + x[2] * c_[index(a, b, 1)];
      sum = sum * x[0] + row;
    }
    return sum;
  }

 private:
  std::size_t index(int a, int b, int c) const { return std::size_t(2 * (a * (degree_ + 1) + b) + c); }
  int degree_;
  std::vector<fifty_digits> c_;
};

/// A differential operator with polynomial coefficients: c x^powers d^orders.
struct operator_term {
  std::array<int, 3> powers{}, orders{};
  fifty_digits c;
};

std::vector<operator_term> generator_terms(const sphere_problem& p) {
  using power = std::array<int, 3>;
  const auto unit = [](std::size_t i) { return power{i == 0, i == 1, i == 2}; };
  const auto sum = [](power a, const power& b) {
    for (std::size_t i = 0; i < 3; ++i) a[i] += b[i];
    return a;
  };
  const fifty_digits c = p.radius, theta = p.damping;
  std::array<fifty_digits, 3> k;
  for (std::size_t i = 0; i < 3; ++i) k[i] = p.quadratic(long(i), long(i));
  std::vector<operator_term> out;
  const auto epsilon = [](std::size_t i, std::size_t j) { return (i + 1) % 3 == j ? 1 : -1; };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, l = (i + 2) % 3;
    out.push_back({sum(unit(j), unit(l)), unit(i), c * (k[l] - k[j])});
    out.push_back({unit(i), unit(i), -theta * c * c * k[i]});  // x (x.Kx) - Kx on the unit sphere
    for (std::size_t m = 0; m < 3; ++m)
      out.push_back({sum(unit(i), sum(unit(m), unit(m))), unit(i), theta * c * c * k[m]});
  }
  // V_i = x cross sigma_i: (V_i)_a = sum eps_abn x_b sigma_in
  const auto q = [&](std::size_t m, std::size_t n) { return fifty_digits(p.covariance(long(m), long(n))); };
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b)
      for (std::size_t d = 0; d < 3; ++d)
        for (std::size_t e = 0; e < 3; ++e) {
          if (a == b || d == e) continue;
          const std::size_t m = 3 - a - b, n = 3 - d - e;
          const fifty_digits half = q(m, n) * epsilon(a, b) * epsilon(d, e) / 2;
          out.push_back({sum(unit(b), unit(e)), sum(unit(a), unit(d)), half});
          if (a == e) out.push_back({unit(b), unit(d), half});  // (V.grad) V
        }
  std::erase_if(out, [](const operator_term& t) { return t.c == 0; });
  return out;
}

polynomial applied(const std::vector<operator_term>& terms, const polynomial& f, int raised) {
  polynomial out(f.degree() + raised);
  f.each([&](const std::array<int, 3>& p, const fifty_digits& coefficient) {
    for (const operator_term& t : terms) {
      int factor = 1;
      std::array<int, 3> q = p;
      for (std::size_t i = 0; i < 3; ++i)
        for (int order = 0; order < t.orders[i]; ++order) factor *= q[i]--;
      if (factor != 0) out.add(q[0] + t.powers[0], q[1] + t.powers[1], q[2] + t.powers[2], factor * t.c * coefficient);
    }
  });
  return out;
}

double supremum(const polynomial& f) {
  constexpr int points = 40;
  double most = 0;
  for (int i = 0; i < points; ++i) {
    const double z = 1 - (2 * i + 1.0) / points, r = std::sqrt(1 - z * z), angle = 2.399963 * i;
    most = std::max(most, std::fabs(double(f({r * std::cos(angle), r * std::sin(angle), z}))));
  }
  return 2 * most;
}

}  // namespace

std::optional<series_value> energy_by_series(const sphere_problem& p, const Eigen::Vector3d& start, double time,
                                             double tolerance) {
  const int raised = p.damping == 0 ? 1 : 2, most_terms = 32 / raised;
  polynomial f(2);
  for (int i = 0; i < 3; ++i)
    f.add(2 * (i == 0), 2 * (i == 1), 2 * (i == 2), p.radius * p.radius / 2 * p.quadratic(i, i));
  const auto terms = generator_terms(p);
  fifty_digits sum = 0, factor = 1;
  double first = 0;
  for (int k = 0; k <= most_terms; ++k) {
    const double left = double(factor) * supremum(f);
    if (k > 1 && left < tolerance) return series_value{double(sum), left};
    if (k == 2) first = left;
    if (k > 2 && left > 10 * first) return std::nullopt;  // too long a time
    sum += factor * f(start.normalized());
    f = applied(terms, f, raised);
    factor *= fifty_digits(time) / (k + 1);
  }
  return std::nullopt;
}

}  // namespace polhode::test
