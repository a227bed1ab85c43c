// SPDX-License-Identifier: Apache-2.0
// The rigid body's face, bound to its step size and orbit: what does not change from step to step is computed once, and
// rotations are polynomials of the degree that the step size asks for.
#pragma once

#include <algorithm>
#include <bit>
#include <memory>
#include <span>
#include <utility>

#include "ensemble/faces/face_of.hpp"
#include "systems/rigid_body/rigid_body_choice.hpp"
#include "systems/rigid_body/rigid_body_forms.hpp"
#include "systems/rigid_body/rigid_body_kernels.hpp"

namespace polhode {

extern template class face_of<rigid_body>;  // isa/rigid_body.cpp

/// What does not depend on the size of rotations: a(Pi) with the Casimir shift.
class bound_body_motion : public face_of<rigid_body> {
  using base = face_of<rigid_body>;
  template <bool dissipation>
  using bound = rigid_body_at<body_parts{true, true, dissipation}, rotation_size::any, summed_noise>;

 public:
  bound_body_motion(const rigid_body& body, double dt, double radius)
      : base(body, dt),
        damped_(constants_of(body, dt, radius, 0, rotation_size::any), {}),
        undamped_(constants_of(body, dt, radius, 0, rotation_size::any), {}),
        dissipates_(parts_of(body).dissipation) {}

  POLHODE_FLATTEN void generator(const double* mu, const step_noise& w, double* xi) const override {
    with_body(w, [&](const auto& body, auto noise) {
      each(mu, xi, [&](const state& x, int lane) { return body.generator_over(x, noise(w, lane)); });
    });
  }
  POLHODE_FLATTEN void drift(const double* mu, double* xi) const override {
    const step_noise none;
    with_body(none, [&](const auto& body, auto noise) {
      each(mu, xi, [&](const state& x, int lane) { return body.generator_over(x, noise(none, lane)); });
    });
  }
  POLHODE_FLATTEN void motion(const double* mu, const step_noise& w, double* out) const override {
    with_body(w, [&](const auto& body, auto noise) {
      each(mu, out, [&](const state& x, int lane) { return body.motion_over(x, noise(w, lane)); });
    });
  }
  POLHODE_FLATTEN void stage(const double* mu, const double* by, const double* c, const step_noise& w,
                             double* out) const override {
    const std::array<pack, 4> a{c[0], c[1], c[2], c[3]};
    with_body(w, [&](const auto& body, auto noise) {
      each(mu, out, [&](const state& x, int lane) {
        const auto y = load(by + lane);
        return a[0] * x + a[1] * y + a[2] * body.motion_over(x + a[3] * y, noise(w, lane));
      });
    });
  }
  POLHODE_FLATTEN void linearised_motion(const double* mu, const step_noise& w, double* value,
                                         double* slope) const override {
    with_body(w, [&](const auto& body, auto noise) {
      each(mu, value, [&](const state& x, int lane) {
        const auto moved = body.linearised_motion_over(x, noise(w, lane));
        for (int row = 0; row < 3; ++row)
          lane_rows<pack>::store(moved.slope[row], slope + 3 * row * block_lanes + lane, block_lanes);
        return moved.value;
      });
    });
  }

 protected:
  bool dissipates() const { return dissipates_; }

  /// sum sigma_i dW^i of a pack of lanes.
  static vec<pack, 3> sum_of(const step_noise& w, int lane) {
    return w.of == kind::own ? lane_rows<pack>::load<3>(w.rows + lane, block_lanes, 3)
                             : detail::lifted<vec<pack, 3>>(w.rows, 3);
  }

  template <class S, class F>
  static void lanes_of(const double* mu, double* out, F f) {
#pragma GCC unroll 1
    for (int lane = 0; lane < block_lanes; lane += lane_rows<S>::width)
      lane_rows<S>::store(f(lane_rows<S>::template load<3>(mu + lane, block_lanes, 3), lane), out + lane, block_lanes);
  }

  const auto& damped() const { return damped_; }

  template <step_noise::kind k>
  using of_kind = std::integral_constant<step_noise::kind, k>;

  /// f(body, noise, kind), noise(w, lane) the increment of the lanes of an S in the form that this body expects, of a
  /// step whose noise is of the kind of w.
  template <class S, class Body, class F>
  static void with_noise_of(Body body, const step_noise& like, F f) {  // a copy: the loop writes other numbers
    const auto increment = [](const vec<S, 3>& b) { return wiener<S, 3>{0, b}; };
    const auto none = [=](const step_noise&, int) { return increment({}); };
    const auto shared = [=](const step_noise& w, int) { return increment(detail::lifted<vec<S, 3>>(w.rows, 3)); };
    const auto own = [=](const step_noise& w, int lane) {
      return increment(lane_rows<S>::template load<3>(w.rows + lane, block_lanes, 3));
    };
    switch (like.of) {
      case kind::none: return f(body.with(no_noise{}), none, of_kind<kind::none>{});
      case kind::shared: return f(body, shared, of_kind<kind::shared>{});
      case kind::own: return f(body, own, of_kind<kind::own>{});
    }
  }
  template <class F>
  void with_body(const step_noise& w, F f) const {
    const auto loop = [&](const auto& body, auto noise, auto) { f(body, noise); };
    if (dissipates_)
      with_noise_of<pack>(damped_, w, loop);
    else
      with_noise_of<pack>(undamped_, w, loop);
  }

 private:
  bound<true> damped_;
  bound<false> undamped_;
  bool dissipates_;
};

/// What depends on the size of rotations and not on how flows turn.
template <rotation_size size>
class bound_body_turns : public bound_body_motion {
  using algebra = typename rotations<size>::algebra;

 public:
  using bound_body_motion::bound_body_motion;

  POLHODE_FLATTEN void exp_action(const double* xi, const double* mu, double* out) const override {
    lanes_of<loop_pack>(mu, out, [&](const auto& x, int lane) {
      using S = typename std::remove_cvref_t<decltype(x)>::scalar;
      return algebra::exp_action(lane_rows<S>::template load<3>(xi + lane, block_lanes, 3), x);
    });
  }

  bool joins_passes() const override {
    return dissipates();
  }  // of the others nobody runs enough to compile it for them
  POLHODE_FLATTEN void exp_of_generator(const double* mu, std::span<const step_noise> w, bool with_area,
                                        double* out) const override {
    with_noise_of<loop_pack>(damped(), w[0], [&](const auto& body, auto noise, auto of) {
      const auto turn = [&](auto exponent) {
        for (const auto& one : w)
          lanes_of<loop_pack>(std::exchange(mu, out), out, [&](const auto& x, int lane) {
            return algebra::exp_action(exponent(one, lane, body.generator_over(x, noise(one, lane))), x);
          });
      };
      if constexpr (of != kind::none)
        if (with_area)
          return turn(
              [area = area_of(of)](const step_noise& one, int lane, const auto& xi) { return xi + area(one, lane); });
      turn([](const step_noise&, int, const auto& xi) { return xi; });
    });
  }
  POLHODE_FLATTEN void generator_of_turned(const double* xi, const double* mu, const step_noise& w,
                                           double* out) const override {
    with_noise_of<loop_pack>(damped(), w, [&](const auto& body, auto noise, auto) {
      lanes_of<loop_pack>(mu, out, [&](const auto& x, int lane) {
        return body.generator_over(algebra::exp_action(load_loop(xi + lane), x), noise(w, lane));
      });
    });
  }
  POLHODE_FLATTEN void exp_of_sum(std::span<const double> c, const double* const* x, const step_noise* w,
                                  const double* mu, double* out) const override {
    const auto turn = [&](auto exponent) {
      lanes_of<loop_pack>(mu, out, [&](const auto& y, int lane) {
        vec<loop_pack, 3> sum = loop_pack(c[0]) * load_loop(x[0] + lane);
        for (std::size_t k = 1; k < c.size(); ++k) sum = sum + loop_pack(c[k]) * load_loop(x[k] + lane);
        return algebra::exp_action(exponent(lane, sum), y);
      });
    };
    const auto with = [&](auto area) { turn([&](int lane, const auto& xi) { return xi + area(*w, lane); }); };
    if (w == nullptr || w->of == kind::none) return turn([](int, const auto& xi) { return xi; });
    if (w->of == kind::shared) return with(area_of(of_kind<kind::shared>{}));
    with(area_of(of_kind<kind::own>{}));
  }

 private:
  static vec<loop_pack, 3> load_loop(const double* at) { return lane_rows<loop_pack>::load<3>(at, block_lanes, 3); }

  /// (w, lane) -> the area's part of a generator.
  static auto area_of(of_kind<kind::shared>) {
    return [](const step_noise& w, int) { return detail::lifted<vec<loop_pack, 3>>(w.rows + 3, 3); };
  }
  auto area_of(of_kind<kind::own>) const {
    return [s = rigid_body(system())](const step_noise& w, int lane) { return s.area_noise(load_loop(w.area + lane)); };
  }
};

/// symmetric: two moments of inertia are equal, and the odd axis is numbered 3.
template <rotation_size size, bool symmetric>
class bound_body final : public bound_body_turns<size> {
  using base = bound_body_turns<size>;
  using kind = step_noise::kind;
  using base::dissipates, base::system;
  using bound = rigid_body_at<body_parts{true, !symmetric, true}, size, summed_noise>;
  using scalar = loop_scalar<strang, size>;
  using vector = vec<scalar, 3>;
  using algebra = typename rotations<size>::algebra;

 public:
  bound_body(const rigid_body& body, double dt, double radius)
      : base(body, dt, radius),
        first_axis_(symmetric ? first_axis_of(body) : 0),
        turns_(parts_of(body).first_turn),
        body_(constants_of(body, dt, radius, first_axis_, size), {}),
        whole_(constants_of(body, dt, radius, 0, size), {}) {}

  shared_steps share(const increment_view& path) const override {
    constexpr std::size_t words = sizeof(shared_step) / sizeof(double);
    shared_steps out{words, std::vector<double>(static_cast<std::size_t>(path.steps) * words)};
    for (std::size_t i = 0; i < static_cast<std::size_t>(path.steps); ++i) {
      const auto row = [&](std::span<const double> all) {
        return all.empty() ? vec<double, 3>{} : vec<double, 3>{{all[3 * i], all[3 * i + 1], all[3 * i + 2]}};
      };
      const auto b = system().noise(row(path.dw)), area = system().area_noise(row(path.area));
      auto step = body_.share(numbered(b), numbered(area));
      step.b = b;
      step.area = area;
      std::ranges::copy(std::bit_cast<std::array<double, words>>(step), out.table.data() + i * words);
    }
    return out;
  }

  POLHODE_FLATTEN void noise_after_free_flow(const double* mu, flow_time t, std::span<const step_noise> w,
                                             double* out) const override {
    if constexpr (!symmetric)
      if (t.parts == 1 && turns_ && dissipates())
        return step_after_step(mu, w, out, [whole = whole_](const auto& body, const vector& x, const auto& noise) {
          return damped(body, whole.free_flow(x, whole_step{}), noise);
        });
    for (const auto& one : w) {
      free_flow(std::exchange(mu, out), t, out);
      damped_noise_flow(out, one, out);
    }
  }
  POLHODE_FLATTEN void noise_after_first_turn(const double* mu, flow_time t, std::span<const step_noise> w,
                                              double* out) const override {
    if constexpr (!symmetric)
      if (t.parts == 1 && turns_ && dissipates())
        return step_after_step(mu, w, out, [](const auto& body, const vector& x, const auto& noise) {
          const half_step half;
          const auto turned = body.last_turn(body.first_turn(x, whole_step{}), half);
          return body.last_turn(damped(body, turned, noise), half);
        });
    for (const auto& one : w) {
      first_turn(std::exchange(mu, out), t, out);
      turned_noise_flow(out, one, out);
    }
  }

  POLHODE_FLATTEN void free_flow(const double* mu, flow_time t, double* out) const override {
    const auto flow = [body = whole_](const vector& x, auto part) { return body.free_flow(x, part); };
    if (!turns_) return bound_body_motion::lanes_of<pack>(mu, out, [](const auto& x, int) { return x; });
    if (t.parts == 1)
      return bound_body_motion::lanes_of<scalar>(mu, out, [&](const vector& x, int) { return flow(x, whole_step{}); });
    if (t.parts == 2)
      return bound_body_motion::lanes_of<scalar>(mu, out, [&](const vector& x, int) { return flow(x, half_step{}); });
    throw_other_time();
  }
  POLHODE_FLATTEN void first_turn(const double* mu, flow_time t, double* out) const override {
    by_parts(mu, t, out, turns_, [body = body_](const vector& x, auto part) { return body.first_turn(x, part); });
  }
  POLHODE_FLATTEN void last_turn(const double* mu, flow_time t, double* out) const override {
    by_parts(mu, t, out, turns_ && !symmetric,
             [body = body_](const vector& x, auto part) { return body.last_turn(x, part); });
  }
  POLHODE_FLATTEN void dissipation_flow(const double* mu, flow_time t, double* out) const override {
    by_parts(mu, t, out, dissipates(),
             [body = body_](const vector& x, auto part) { return body.dissipation_flow(x, part); });
  }
  POLHODE_FLATTEN void noise_flow(const double* mu, const step_noise& w, double* out) const override {
    with_noise(w, [&](const auto& body, auto noise) {
      numbered_lanes(mu, out, [&](const vector& x, int lane) { return body.noise_flow(x, noise(lane)); });
    });
  }
  POLHODE_FLATTEN void damped_noise_flow(const double* mu, const step_noise& w, double* out) const override {
    if (w.of == kind::none) return dissipation_flow(mu, {this->dt(), 1}, out);
    if (!dissipates()) return noise_flow(mu, w, out);
    with_noise(w, [&](const auto& body, auto noise) {
      numbered_lanes(mu, out, [&](const vector& x, int lane) { return body.damped_noise_flow(x, noise(lane)); });
    });
  }
  POLHODE_FLATTEN void turned_noise_flow(const double* mu, const step_noise& w, double* out) const override {
    if (!dissipates() || symmetric) return base::turned_noise_flow(mu, w, out);
    const half_step half;
    if (w.of == kind::none)
      return numbered_lanes(mu, out, [body = body_, half](const vector& x, int) {
        return body.last_turn(body.dissipation_flow(body.last_turn(x, half), whole_step{}), half);
      });
    with_noise(w, [&](const auto& body, auto noise) {
      numbered_lanes(mu, out, [&](const vector& x, int lane) {
        return body.last_turn(body.damped_noise_flow(body.last_turn(x, half), noise(lane)), half);
      });
    });
  }

 private:
  int axis(int k) const { return symmetric ? (k + first_axis_) % 3 : k; }
  template <class S>
  vec<S, 3> numbered(const vec<S, 3>& v) const {
    return {{v[axis(0)], v[axis(1)], v[axis(2)]}};
  }

  /// The same in the numbering of the axes that the flows have.
  template <class F>
  void numbered_lanes(const double* mu, double* out, F f) const {
    const std::array<int, 3> row{axis(0) * block_lanes, axis(1) * block_lanes, axis(2) * block_lanes};
#pragma GCC unroll 1
    for (int lane = 0; lane < block_lanes; lane += lane_rows<scalar>::width) {
      vector x;
      for (int k = 0; k < 3; ++k) x[k].copy_from(mu + row[static_cast<std::size_t>(k)] + lane, stdx::element_aligned);
      x = f(x, lane);
      for (int k = 0; k < 3; ++k) x[k].copy_to(out + row[static_cast<std::size_t>(k)] + lane, stdx::element_aligned);
    }
  }

  template <class Body, class Noise>
  static vector damped(const Body& body, const vector& x, const Noise& noise) {
    if constexpr (std::is_same_v<Noise, no_noise>)
      return body.dissipation_flow(x, whole_step{});
    else
      return body.damped_noise_flow(x, noise);
  }
  /// x = step(body, x, noise), all lanes of a step before the next one: they do not wait for each other.
  template <class Step>
  void step_after_step(const double* mu, std::span<const step_noise> w, double* out, Step step) const {
    const auto increment = [](const vector& b) { return wiener<scalar, 3>{0, b}; };
    const bound body(body_);  // a copy: what the loop writes are not its constants
    for (const auto& one : w) {
      const double* from = std::exchange(mu, out);
      switch (one.of) {
        case kind::none:
          numbered_lanes(from, out, [&](const vector& x, int) { return step(body, x, no_noise{}); });
          break;
        case kind::own:
          numbered_lanes(from, out, [&, rows = one.rows](const vector& x, int lane) {
            const auto b = lane_rows<scalar>::template load<3>(rows + lane, block_lanes, 3);
            return step(body, x, increment(numbered(b)));
          });
          break;
        case kind::shared:
          numbered_lanes(from, out, [&, under = body.with(shared_in(one))](const vector& x, int) {
            return step(under, x, increment({}));
          });
      }
    }
  }
  static shared_noise shared_in(const step_noise& w) {
    std::array<double, sizeof(shared_step) / sizeof(double)> raw{};
    std::copy_n(w.rows, raw.size(), raw.begin());
    shared_noise shared;
    shared.step = std::bit_cast<shared_step>(raw);
    return shared;
  }

  [[noreturn, gnu::cold, gnu::noinline]] static void throw_other_time() {
    throw std::logic_error("a rigid body bound to its step flows through the whole of it or half of it");
  }

  /// flow(x, part of the step); where it is not there the state stays.
  template <class Flow>
  void by_parts(const double* mu, flow_time t, double* out, bool there, Flow flow) const {
    if (!there)
      bound_body_motion::lanes_of<pack>(mu, out, [](const auto& x, int) { return x; });
    else if (t.parts == 1)
      numbered_lanes(mu, out, [&](const vector& x, int) { return flow(x, whole_step{}); });
    else if (t.parts == 2)
      numbered_lanes(mu, out, [&](const vector& x, int) { return flow(x, half_step{}); });
    else
      throw_other_time();
  }

  /// f(body, noise) as in bound_body_motion, in the numbering of the flows.
  template <class F>
  void with_noise(const step_noise& w, F f) const {
    const auto increment = [](const vector& b) { return wiener<scalar, 3>{0, b}; };
    if (w.of == kind::own)
      return f(bound(body_), [=, this, rows = w.rows](int lane) {
        return increment(numbered(lane_rows<scalar>::template load<3>(rows + lane, block_lanes, 3)));
      });
    f(body_.with(w.of == kind::shared ? shared_in(w) : shared_noise{}), [=](int) { return increment({}); });
  }

  int first_axis_;
  bool turns_;
  bound body_;
  rigid_body_at<body_parts{true, true, true}, size, summed_noise>
      whole_;  ///< for the free motion in the body's own axes
};

}  // namespace polhode
