// SPDX-License-Identifier: Apache-2.0
// The face of a system whose flows are those of another form of it, bound to the step size and the orbit.
#pragma once

#include <stdexcept>
#include <utility>

#include "ensemble/faces/face_of.hpp"

namespace polhode {

/// Bound: a System with flows of its own, over parts of the step where they are computed in advance. Two packs advance
/// together, as flows are long chains.
template <class System, class Bound>
class face_with_flows final : public face_of<System> {
  static constexpr int N = System::dimension;
  using rows = lane_rows<two_packs>;
  using vector = vec<two_packs, N>;

 public:
  face_with_flows(System system, Bound bound, double dt)
      : face_of<System>(std::move(system), dt), bound_(std::move(bound)) {}

  void free_flow(const double* mu, flow_time t, double* out) const override {
    over(mu, t, out, [&](const vector& x, auto part) { return bound_.free_flow(x, part); });
  }
  void dissipation_flow(const double* mu, flow_time t, double* out) const override {
    over(mu, t, out, [&](const vector& x, auto part) { return bound_.dissipation_flow(x, part); });
  }
  void first_turn(const double* mu, flow_time t, double* out) const override {
    over(mu, t, out, [&](const vector& x, auto part) { return bound_.first_turn(x, part); });
  }
  void last_turn(const double* mu, flow_time t, double* out) const override {
    over(mu, t, out, [&](const vector& x, auto part) { return bound_.last_turn(x, part); });
  }
  void damped_noise_flow(const double* mu, const step_noise& w, double* out) const override {
    const half_step half{this->dt()};
    each(mu, out, [&](const vector& x, int lane) {
      return bound_.dissipation_flow(turned(bound_.dissipation_flow(x, half), w, lane), half);
    });
  }

 private:
  template <class F>
  POLHODE_FLATTEN static void each(const double* mu, double* out, F f) {
#pragma GCC unroll 1
    for (int lane = 0; lane < block_lanes; lane += rows::width)
      rows::store(f(rows::template load<N>(mu + lane, block_lanes, N), lane), out + lane, block_lanes);
  }
  template <class Flow>
  void over(const double* mu, flow_time t, double* out, Flow flow) const {
    if (t.parts == 1)
      each(mu, out, [&](const vector& x, int) { return flow(x, whole_step{this->dt()}); });
    else if (t.parts == 2)
      each(mu, out, [&](const vector& x, int) { return flow(x, half_step{this->dt()}); });
    else
      throw std::logic_error("a system bound to its step flows through the whole of it or half of it");
  }
  static vector turned(const vector& x, const step_noise& w, int lane) {
    using kind = step_noise::kind;
    if (w.of == kind::none) return x;
    if (w.of == kind::shared) return detail::changed(x, w.rows + 2 * N);
    return System::algebra::exp_action(rows::template load<N>(w.rows + lane, block_lanes, N), x);
  }

  Bound bound_;
};

/// The same where the bound form fits, else the system's own flows.
template <class System, class Bound>
std::shared_ptr<const face> bound_where_it_fits(const System& system, std::span<const double> momentum, double dt) {
  if (!momentum.empty())
    if (Bound bound(system, {momentum.begin(), momentum.end()}, dt); bound.fits())
      return std::make_shared<face_with_flows<System, Bound>>(system, std::move(bound), dt);
  return std::make_shared<face_of<System>>(system, dt);
}

}  // namespace polhode
