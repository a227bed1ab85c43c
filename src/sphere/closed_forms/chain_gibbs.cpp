// SPDX-License-Identifier: Apache-2.0
#include "sphere/closed_forms/chain_gibbs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sphere/harmonics/harmonics.hpp"
#include "sphere/site_observable.hpp"

namespace polhode {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double tolerance = 1e-12;
constexpr int first_degree = 16, most_degree = 128, most_degree_of_rings = 40;  // a ring multiplies matrices

/// Spins in the order of their bonds; closed: the last is bound to the first.
struct component {
  std::vector<int> sites;
  bool closed = false;
};

std::vector<int> neighbours(const MatrixXd& exchange, int i) {
  std::vector<int> out;
  for (int j = 0; j < exchange.rows(); ++j)
    if (j != i && exchange(i, j) != 0) out.push_back(j);
  return out;
}

/// From one end, or from anywhere on a ring.
component walk(const MatrixXd& exchange, int start, std::vector<bool>& seen) {
  component out;
  for (int at = start; at >= 0;) {
    out.sites.push_back(at);
    seen[static_cast<std::size_t>(at)] = true;
    int next = -1;
    for (const int j : neighbours(exchange, at))
      if (!seen[static_cast<std::size_t>(j)]) next = j;
    at = next;
  }
  out.closed = out.sites.size() > 2 && exchange(out.sites.front(), out.sites.back()) != 0;
  return out;
}

std::vector<component> components_of(const MatrixXd& exchange) {
  std::vector<bool> seen(static_cast<std::size_t>(exchange.rows()), false);
  std::vector<component> out;
  for (const std::size_t most_bonds : {1U, 2U})  // ends first, then what has none
    for (int i = 0; i < exchange.rows(); ++i)
      if (!seen[static_cast<std::size_t>(i)] && neighbours(exchange, i).size() <= most_bonds)
        out.push_back(walk(exchange, i, seen));
  return out;
}

/// One component of the spins on the points of a rule.
class transfer_matrices {
 public:
  transfer_matrices(const chain_gibbs& law, const component& of, const sphere_rule& rule)
      : law_(law), of_(of), rule_(rule) {
    for (const int site : of.sites) {
      VectorXd own = site_energies(site);
      const double least = own.minCoeff();
      mass_.emplace_back(((least - own.array()) * law.beta).exp() * rule.weights.array());
    }
  }

  double energy() const {
    if (is_uniform_ring())
      return static_cast<double>(size()) * (mean_at(0, site_energies(of_.sites[0])) + mean_of_bond(0));
    double sum = 0;
    for (std::size_t k = 0; k < size(); ++k) sum += mean_at(k, site_energies(of_.sites[k]));
    for (std::size_t k = 0; k < bonds(); ++k) sum += mean_of_bond(k);
    return sum;
  }
  double component_mean(int site, int axis, int power) const {
    const auto k = static_cast<std::size_t>(std::ranges::find(of_.sites, site) - of_.sites.begin());
    const VectorXd values = (length(k) * rule_.points.col(axis)).array().pow(power);
    return mean_at(k, values);
  }

 private:
  std::size_t size() const { return of_.sites.size(); }
  std::size_t bonds() const { return of_.closed ? size() : size() - 1; }
  bool is_uniform_ring() const {
    if (!of_.closed) return false;
    for (std::size_t k = 0; k < size(); ++k) {
      const auto &one = site(of_.sites[k]), &first = site(of_.sites[0]);
      if (one.length != first.length || one.quadratic != first.quadratic || one.field != first.field) return false;
      if (strength(k) != strength(0)) return false;
    }
    return true;
  }
  std::size_t after(std::size_t k) const { return (k + 1) % size(); }
  const chain_site& site(int which) const { return law_.sites[static_cast<std::size_t>(which)]; }
  double length(std::size_t k) const { return site(of_.sites[k]).length; }
  double strength(std::size_t k) const {
    return law_.exchange(of_.sites[k], of_.sites[after(k)]) * length(k) * length(after(k));
  }

  VectorXd site_energies(int which) const {
    const auto& [quadratic, field, length] = site(which);
    const MatrixXd s = length * rule_.points;
    return 0.5 * (s * quadratic).cwiseProduct(s).rowwise().sum() + s * field;
  }
  MatrixXd cosines() const { return rule_.points * rule_.points.transpose(); }
  /// exp(-beta J_ij S_i.S_j), at most one.
  MatrixXd bond_factor(std::size_t k) const {
    const double x = law_.beta * strength(k);
    return (-x * cosines().array() - std::fabs(x)).exp();
  }

  /// With spin k at a point: the factor of all others, of the right relative size over the points. The diagonal of what
  /// goes round a ring, the product of what comes from both ends of a chain.
  VectorXd others(std::size_t k) const {
    if (of_.closed) return (bond_factor(k) * around(after(k), k)).diagonal();
    return from_left(k).cwiseProduct(from_right(k));
  }
  VectorXd from_left(std::size_t k) const {
    VectorXd f = VectorXd::Ones(rule_.weights.size());
    for (std::size_t i = 0; i < k; ++i) f = normalised(bond_factor(i).transpose() * mass_[i].cwiseProduct(f));
    return f;
  }
  VectorXd from_right(std::size_t k) const {
    VectorXd f = VectorXd::Ones(rule_.weights.size());
    for (std::size_t i = size() - 1; i > k; --i) f = normalised(bond_factor(i - 1) * mass_[i].cwiseProduct(f));
    return f;
  }
  /// The spins from `first` to the one before `end`, each with its mass, and their bonds to the next.
  MatrixXd around(std::size_t first, std::size_t end) const {
    MatrixXd out = mass_[first].asDiagonal() * bond_factor(first);
    for (std::size_t i = after(first); i != end; i = after(i)) {
      out = out * (mass_[i].asDiagonal() * bond_factor(i));
      out /= out.cwiseAbs().maxCoeff();
    }
    return out;
  }
  static VectorXd normalised(const VectorXd& f) { return f / f.maxCoeff(); }

  double mean_at(std::size_t k, const VectorXd& values) const {
    const VectorXd mass = mass_[k].cwiseProduct(others(k));
    return mass.dot(values) / mass.sum();
  }
  double mean_of_bond(std::size_t k) const {
    const std::size_t next = after(k);
    MatrixXd joint = mass_[k].asDiagonal() * bond_factor(k) * mass_[next].asDiagonal();
    if (of_.closed)
      joint = joint.cwiseProduct(rest_of_ring(k));
    else
      joint = from_left(k).asDiagonal() * joint * from_right(next).asDiagonal();
    return strength(k) * joint.cwiseProduct(cosines()).sum() / joint.sum();
  }
  /// At (x, y): what goes from spin k + 1 at y round to spin k at x, without the masses of both.
  MatrixXd rest_of_ring(std::size_t k) const {
    const std::size_t next = after(k);
    MatrixXd way = bond_factor(next);
    if (after(next) != k) way = way * around(after(next), k);
    return way.transpose();
  }

  const chain_gibbs& law_;
  const component& of_;
  const sphere_rule& rule_;
  std::vector<VectorXd> mass_;
};

double average(const chain_gibbs& law, const std::vector<component>& all, const site_observable& f, int degree) {
  const auto rule = sphere_quadrature(degree);
  double sum = 0;
  for (const auto& one : all) {
    const bool holds = std::ranges::find(one.sites, f.site) != one.sites.end();
    if (f.energy)
      sum += transfer_matrices(law, one, rule).energy();
    else if (holds)
      sum += transfer_matrices(law, one, rule).component_mean(f.site, f.axis, f.power);
  }
  return sum;
}

/// Of the observable: what rounding and the tolerance are measured by.
double size_of(const chain_gibbs& law, const site_observable& f) {
  const auto length = [&](Eigen::Index i) { return law.sites[static_cast<std::size_t>(i)].length; };
  if (!f.energy) return std::pow(length(f.site), f.power);
  double sum = 0;
  for (Eigen::Index i = 0; i < law.exchange.rows(); ++i) {
    const auto& site = law.sites[static_cast<std::size_t>(i)];
    sum += 0.5 * site.quadratic.norm() * site.length * site.length + site.field.norm() * site.length;
    for (Eigen::Index j = 0; j < i; ++j) sum += std::fabs(law.exchange(i, j)) * length(i) * length(j);
  }
  return sum;
}

}  // namespace

bool chain_gibbs::solvable() const {
  for (int i = 0; i < exchange.rows(); ++i)
    if (neighbours(exchange, i).size() > 2) return false;
  return true;
}

std::optional<reference_value> chain_gibbs::mean(std::string_view observable) const {
  const auto f = site_observable_named(observable, static_cast<int>(sites.size()));
  if (!f) return std::nullopt;
  const auto all = components_of(exchange);
  const int most = std::ranges::any_of(all, &component::closed) ? most_degree_of_rings : most_degree;
  const double size = size_of(*this, *f);
  double before = average(*this, all, *f, first_degree);
  for (int degree = std::min(2 * first_degree, most);; degree = std::min(2 * degree, most)) {
    const double now = average(*this, all, *f, degree), change = std::fabs(now - before);
    const bool converged = change <= tolerance * size;
    if (converged || degree == most)
      return reference_value{.value = now,
                             .uncertainty = std::max(change, 1e-14 * size),
                             .reason = converged ? "" : "the law is too narrow for the quadrature over the spheres"};
    before = now;
  }
}

}  // namespace polhode
