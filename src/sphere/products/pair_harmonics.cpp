// SPDX-License-Identifier: Apache-2.0
#include "sphere/products/pair_harmonics.hpp"

#include <cmath>

#include "sphere/harmonics/harmonics.hpp"
#include "sphere/harmonics/observables.hpp"

namespace polhode {
namespace {

constexpr int size_of_block(int l1, int l2) { return (2 * l1 + 1) * (2 * l2 + 1); }

int degree_of(int harmonic) { return static_cast<int>(std::sqrt(harmonic + 0.5)); }

/// The observable as far as it depends on one site alone.
sphere_function of_site(const sphere_problem& site, const site_observable& f) {
  if (f.energy) return [&site](const Eigen::Vector3d& pi) { return site.energy(pi); };
  return [f](const Eigen::Vector3d& pi) { return std::pow(pi[f.axis], f.power); };
}

}  // namespace

int pair_harmonic_count(int degree) { return (degree + 1) * (degree + 2) * (degree * degree + 3 * degree + 3) / 6; }

pair_index::pair_index(int degree) : degree_(degree), first_(static_cast<std::size_t>(harmonic_count(degree)), 0) {
  int next = 0;
  for (int both = 0; both <= degree; ++both)
    for (int l1 = 0; l1 <= both; next += size_of_block(l1, both - l1), ++l1)
      first_[static_cast<std::size_t>(l1 * (degree + 1) + both - l1)] = next;
}

int pair_index::operator()(int k, int n) const {
  const int l1 = degree_of(k), l2 = degree_of(n);
  return first_[static_cast<std::size_t>(l1 * (degree_ + 1) + l2)] + (k - l1 * l1) * (2 * l2 + 1) + n - l2 * l2;
}

Eigen::VectorXd pair_harmonics_at(const Eigen::Vector3d& x1, const Eigen::Vector3d& x2, int degree) {
  const Eigen::VectorXd one = harmonics_at(x1, degree), other = harmonics_at(x2, degree);
  const pair_index index(degree);
  Eigen::VectorXd out(pair_harmonic_count(degree));
  for (int k = 0; k < one.size(); ++k)
    for (int n = 0; n < harmonic_count(degree - degree_of(k)); ++n) out[index(k, n)] = one[k] * other[n];
  return out;
}

double pair_supremum(const Eigen::VectorXd& coefficients, int first_degree) {
  double sum = 0;
  Eigen::Index at = 0;
  for (int both = first_degree; at < coefficients.size(); ++both)
    for (int l1 = 0; l1 <= both; ++l1) {
      const int size = size_of_block(l1, both - l1);
      sum += std::sqrt(size) / unit_of_pair_mean * coefficients.segment(at, size).norm();
      at += size;
    }
  return sum;
}

Eigen::VectorXd pair_coefficients(const sphere_pair& pair, const site_observable& f, int degree) {
  const pair_index index(degree);
  Eigen::VectorXd out = Eigen::VectorXd::Zero(pair_harmonic_count(degree));
  for (const int site : {0, 1}) {
    if (!f.energy && site != f.site) continue;
    const auto& problem = pair.sites[static_cast<std::size_t>(site)];
    const Eigen::VectorXd alone = observable_coefficients(problem, of_site(problem, f), 2);
    for (int k = 0; k < alone.size(); ++k) out[site == 0 ? index(k, 0) : index(0, k)] += unit_of_mean * alone[k];
  }
  if (f.energy)  // x_1.x_2 is 4 pi / 3 times the sum of the products of equal harmonics of degree one
    for (int k = 1; k <= 3; ++k)
      out[index(k, k)] += pair.exchange * pair.sites[0].radius * pair.sites[1].radius * unit_of_pair_mean / 3;
  return out;
}

}  // namespace polhode
