// SPDX-License-Identifier: Apache-2.0
// Bodies all over the coadjoint orbit of a momentum, by address.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "ensemble/coadjoint_matrices.hpp"

namespace polhode {

/// Bodies at Ad*_exp(xi_4) … Ad*_exp(xi_1) momentum, the components of every xi_i independent normals of variance 3.
/// Turns of that law forget what they turn: on a product of spheres bodies are uniform on each to 2e-6, as the mean of
/// the normalised character of degree l is (1 + 2 sum_{m=1}^l (1 - 3 m^2) exp(-3 m^2 / 2)) / (2 l + 1), at most 0.036
/// in size. An orbit that is not compact has no uniform law.
class orbit_start {
 public:
  orbit_start(const model&, std::span<const double> momentum);

  /// The block of bodies first_body …: states [component][lane].
  void fill(std::uint64_t seed, std::uint64_t first_body, std::span<double> states) const;
  std::vector<double> block(std::uint64_t seed, std::uint64_t first_body) const;

 private:
  Eigen::VectorXd momentum_;
  std::vector<Eigen::MatrixXd> coadjoint_;
};

}  // namespace polhode
