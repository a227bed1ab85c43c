// SPDX-License-Identifier: Apache-2.0
// The fluid on the torus: its table, what it offers, and its faces.
#include <polhode/systems/sine_euler.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "problem/vectors.hpp"
#include "systems/cpp_text.hpp"
#include "systems/system_source.hpp"
#include "systems/systems.hpp"

namespace polhode {
namespace {

[[maybe_unused]] sine_euler make_sine_euler(const report::scene& s) {
  return {static_cast<int>(s.number("n")), dissipation_of(s),
          sine_euler::from_vectors(noise_vectors_of(s), static_cast<int>(s.momentum.size()))};
}

}  // namespace
}  // namespace polhode

POLHODE_BEHIND_FACES(sine_euler, polhode::make_sine_euler);

#if POLHODE_COMPILED_ONCE
namespace polhode {
namespace {

using report::number_rows;
using report::shape;

std::size_t components_of_sine_euler(std::size_t rows) { return rows * rows - 1; }

/// The largest row sum of sum_i ad(sigma_i)^T ad(sigma_i): no less than |[sigma_i, mu]|^2 of a mu of length one,
/// summed.
double noise_rate(const report::scene& s) {
  const auto& vectors = noise_vectors_of(s);
  const auto size = static_cast<Eigen::Index>(s.momentum.size());
  Eigen::MatrixXd sigma(size, static_cast<Eigen::Index>(vectors.size())), squares = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index i = 0; i < sigma.cols(); ++i)
    sigma.col(i) = Eigen::Map<const Eigen::VectorXd>(vectors[static_cast<std::size_t>(i)].data(), size);
  for (Eigen::Index i = 0; i < sigma.cols(); ++i) {
    const Eigen::MatrixXd ad = adjoint_of<su>(sigma, i);
    squares += ad.transpose() * ad;
  }
  return squares.cwiseAbs().rowwise().sum().maxCoeff();
}

/// |[xi, mu]| <= bracket |xi| |mu|, as the eigenvalues of H(xi) lie in a range of (2 n)^(1/2) |xi|.
rate_bounds sine_euler_rates(const report::scene& s) {
  const auto n = s.number("n");
  const double bracket = n / (4 * std::numbers::pi) * std::sqrt(2 * n), size = bracket * length(s.momentum);
  const double least = 2 / ((n - 1) * (n - 1));  // of 1 / |k|^2, whose greatest is 1
  rate_bounds out;
  out.motion = size;
  out.damping = size * size * (1 - least);
  out.dissipation = dissipation_of(s) * out.damping;
  out.noise = noise_rate(s);
  return out;
}

std::string sine_euler_in_cpp(const report::scene& s) {
  return fmt::format("{}  const sine_euler body({}, {}, sine_euler::from_vectors(sigma, {}));\n", noise_in_cpp(s),
                     s.number("n"), dissipation_of(s), s.momentum.size());
}

capabilities sine_euler_offers(const report::scene& s) {
  capabilities out{.rates = sine_euler_rates(s)};
  out.in_cpp = sine_euler_in_cpp(s);
  out.in_cpp_sized = true;
  out.in_unit = [=](int power) { return with_momentum_unit(s, power); };
  return out;
}

parameter_rule sine_euler_rows() {
  auto rule = number_of("n", "1", "of su(n): the modes k_1 and k_2 go from -(n - 1)/2 to (n - 1)/2");
  rule.accepts = "3 or 5";
  rule.read = [](const number_rows& given, shape s) -> std::optional<number_rows> {
    const auto known = [](double n) { return n == 3 || n == 5; };
    return s == shape::number && known(given[0][0]) ? std::optional(given) : std::nullopt;
  };
  return rule;
}

parameter_rule sine_euler_states(std::size_t rows) {
  return nonzero_vector_of("momentum", components_of_sine_euler(rows), "1 / time",
                           "initial sqrt(2) (Re, Im) of the vorticity's modes (0, 1), …; (1, -(n - 1)/2), …");
}

parameter_rule sine_euler_noise(std::size_t rows) {
  return noise_vectors(components_of_sine_euler(rows), "1 / time^(1/2)");
}

}  // namespace

system_entry sine_euler_system();

system_entry sine_euler_system() {
  return {
      .name = "sine_euler",
      .title =
          "Dissipative stochastic ideal fluid on the torus, truncated to n = 3 or 5 modes a side, on su(n)*; "
          "n - 1 Casimirs",
      .dimension = 0,
      .unit = "1 / time",
      .parameters = {sine_euler_rows(), dissipation_strength("time", "dissipation: dh/dt = -theta |ad*_Omega mu|^2"),
                     by_rows(sine_euler_noise, "a finite number, n^2 - 1 of them, or a list of such vectors")},
      .observables = {{"energy", "h"}, {"mu_1", "first component; so for every one"}},
      .bind = POLHODE_BOUND_TO_SCHEMES(sine_euler),
      .offers = sine_euler_offers,
      .momentum = by_rows(sine_euler_states, "n^2 - 1 finite numbers, not all zero")};
}

}  // namespace polhode
#endif
