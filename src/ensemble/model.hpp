// SPDX-License-Identifier: Apache-2.0
// A system behind one virtual face, a state at a time: what an experiment measures with, not its inner loop.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include <polhode/systems/constant_noise.hpp>

#include "ensemble/kernel.hpp"
#include "ensemble/noise/noise_layout.hpp"

namespace polhode {

/// A Lie-Poisson system of any dimension.
class model {
 public:
  virtual ~model() = default;
  virtual int dimension() const = 0;
  virtual noise_layout layout() const = 0;  ///< of its noise
  virtual noise_class noise() const = 0;
  virtual double energy(std::span<const double> mu) const = 0;
  virtual double dissipation_rate(std::span<const double> mu) const = 0;  ///< -dh/dt without noise
  virtual std::vector<double> casimirs(std::span<const double> mu) const = 0;
  /// What a change of each Casimir is measured by: its own size, but where it may vanish.
  virtual std::vector<double> casimir_sizes(std::span<const double> mu) const = 0;
  /// Both for a block, [component][lane]: energies [lane], Casimirs [casimir][lane].
  virtual void conserved(std::span<const double> states, std::span<double> energies,
                         std::span<double> casimirs) const = 0;
  virtual void drift(std::span<const double> mu, std::span<double> out) const = 0;       ///< ad*_a(mu) mu
  virtual void drifts(std::span<const double> states, std::span<double> out) const = 0;  ///< of a block
  /// ad*_xi mu: linear in both; over unit vectors xi the columns of the Lie-Poisson bracket at mu.
  virtual void coadjoint(std::span<const double> xi, std::span<const double> mu, std::span<double> out) const = 0;
  /// Chen's relation over groups of `factor` steps: [step][channel][lane] in and out. An input without areas is a
  /// piecewise linear path.
  virtual void coarsen(const increment_view& fine, int factor, std::span<double> dw, std::span<double> area) const = 0;
  /// The driven ordinary differential equation over steps of dt, to fourth order: the reference for strong errors.
  virtual std::unique_ptr<kernel> reference(double dt) const = 0;
};

}  // namespace polhode
