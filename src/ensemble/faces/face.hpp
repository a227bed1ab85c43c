// SPDX-License-Identifier: Apache-2.0
// A Lie-Poisson system behind virtual functions, each called once for a group of lanes. Whatever a step asks of its
// system is one of them, so a scheme is compiled once for all systems and a system once for all schemes.
//
// A state is [row][lane]: a row for each component and, on a face of tangents, for each component of each tangent,
// which the functions carry along by their derivatives. Every function reads all that it needs of a pack of lanes
// before it writes there: its result may take the place of an argument.
#pragma once

#include <span>
#include <stdexcept>

#include "ensemble/kernel.hpp"

namespace polhode {

/// How long a flow runs: t, and the part of the step 1/parts that this is; 0 parts: some other time.
struct flow_time {
  double t;
  int parts;
};

/// Increments of one step for a group of lanes, as they are drawn: [channel][lane], rows block_lanes apart.
struct drawn_increments {
  const double* dw = nullptr;
  const float* singles = nullptr;  ///< in place of dw: dw = scale * single
  double scale = 1;
};

/// The noise of one step, in a form that belongs to the face.
struct step_noise {
  enum class kind { none, own, shared };
  kind of = kind::none;
  const double* rows = nullptr;  ///< own: what `take` has written; shared: a row of the table that `share` has made
  const double* area = nullptr;  ///< own: [pair][lane], rows block_lanes apart
};

class face {
 public:
  virtual ~face() = default;

  virtual double dt() const = 0;
  virtual int components() const = 0;
  virtual int tangents() const = 0;  ///< carried along with each state
  virtual int channels() const = 0;  ///< of its noise
  virtual int lanes() const = 0;     ///< of a group; divides block_lanes
  int rows() const { return components() * (1 + tangents()); }

  /// [row][lane] that `take` writes; what a step of common noise takes in the table.
  virtual int noise_rows() const = 0;
  virtual void take(const drawn_increments&, double* rows) const = 0;
  virtual shared_steps share(const increment_view& one_path) const = 0;

  // What a step is built of (polhode/systems/lie_poisson.hpp).
  virtual void generator(const double* mu, const step_noise&, double* xi) const = 0;
  virtual void drift(const double* mu, double* xi) const = 0;
  virtual void motion(const double* mu, const step_noise&, double* out) const = 0;
  /// c[0] mu + c[1] x + c[2] motion(mu + c[3] x): a stage with its motion in one pass.
  virtual void stage(const double* mu, const double* x, const double* c, const step_noise&, double* out) const = 0;
  virtual void noise(const double* mu, const step_noise&, double* out) const = 0;
  virtual void noise_slope(const double* mu, const double* by, const step_noise&, double* out) const = 0;
  virtual void noise_twice(const double* mu, const step_noise&, double* out) const = 0;
  virtual void area_noise(const double* mu, const step_noise&, double* out) const = 0;
  virtual void ito_drift(const double* mu, double* out) const = 0;
  /// `motion` and its derivative by the components, [row][column][lane]; of a face without tangents and of at most six
  /// components. Others are differentiated along tangents.
  virtual void linearised_motion(const double* mu, const step_noise&, double* value, double* slope) const = 0;
  virtual void contracted_motion(const double* m, const step_noise&, double* out) const = 0;
  virtual void linearised_contracted_motion(const double* m, const step_noise&, double* value, double* slope) const = 0;

  // The algebra.
  virtual void bracket(const double* xi, const double* eta, double* out) const = 0;
  virtual void coad(const double* xi, const double* mu, double* out) const = 0;
  virtual void exp_action(const double* xi, const double* mu, double* out) const = 0;
  virtual void cayley_action(const double* xi, const double* mu, double* out) const = 0;
  virtual void dexp_inv(const double* u, const double* v, double* out) const = 0;
  virtual void orbit_projection(const double* mu, const double* onto, double* out) const = 0;
  virtual void sandwich(const double* xi, const double* mu, double* out) const = 0;

  // Flows.
  virtual void free_flow(const double* mu, flow_time, double* out) const = 0;
  virtual void dissipation_flow(const double* mu, flow_time, double* out) const = 0;
  virtual void first_turn(const double* mu, flow_time, double* out) const = 0;
  virtual void last_turn(const double* mu, flow_time, double* out) const = 0;
  virtual void noise_flow(const double* mu, const step_noise&, double* out) const = 0;
  virtual void damped_noise_flow(const double* mu, const step_noise&, double* out) const = 0;
  virtual void turned_noise_flow(const double* mu, const step_noise&, double* out) const = 0;

  // Two operations in one pass, of faces whose operations are so short that to load and store a state is a part of
  // them. What may be all of a step takes several in a row; their noise is of one kind.
  virtual bool joins_passes() const { return false; }
  /// mu -> exp(generator(mu) + area) mu; the area where `with_area`.
  virtual void exp_of_generator(const double* /*mu*/, std::span<const step_noise>, bool /*with_area*/,
                                double* /*out*/) const {
    lacks_joined_passes();
  }
  virtual void noise_after_free_flow(const double* /*mu*/, flow_time, std::span<const step_noise>,
                                     double* /*out*/) const {
    lacks_joined_passes();
  }
  virtual void noise_after_first_turn(const double* /*mu*/, flow_time, std::span<const step_noise>,
                                      double* /*out*/) const {
    lacks_joined_passes();
  }
  /// generator(exp(xi) mu).
  virtual void generator_of_turned(const double* /*xi*/, const double* /*mu*/, const step_noise&,
                                   double* /*out*/) const {
    lacks_joined_passes();
  }
  /// exp(sum c_i x_i + area) mu, of one to three terms; the area of that noise, where there is one.
  virtual void exp_of_sum(std::span<const double> /*c*/, const double* const* /*x*/, const step_noise* /*area*/,
                          const double* /*mu*/, double* /*out*/) const {
    lacks_joined_passes();
  }

 private:
  [[noreturn]] static void lacks_joined_passes() {
    throw std::logic_error("a tape joins operations whose face takes one at a time");
  }
};

}  // namespace polhode
