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

  /// f(body, noise), noise(w, lane) the increment of the lanes of an S in the form that this body expects, of a step
  /// whose noise is of the kind of w.
  template <class S = pack, class F>
  void with_body(const step_noise& kind_of, F f) const {
    const auto by_noise = [&](auto body) {  // a copy: what the loop writes are not its constants
      const auto increment = [](const vec<S, 3>& b) { return wiener<S, 3>{0, b}; };
      switch (kind_of.of) {
        case kind::none: return f(body.with(no_noise{}), [=](const step_noise&, int) { return increment({}); });
        case kind::shared:
          return f(body, [=](const step_noise& w, int) { return increment(detail::lifted<vec<S, 3>>(w.rows, 3)); });
        case kind::own:
          return f(body, [=](const step_noise& w, int lane) {
            return increment(lane_rows<S>::template load<3>(w.rows + lane, block_lanes, 3));
          });
      }
    };
    if (dissipates_)
      by_noise(damped_);
    else
      by_noise(undamped_);
  }

 private:
  bound<true> damped_;
  bound<false> undamped_;
  bool dissipates_;
};

/// symmetric: two moments of inertia are equal, and the odd axis is numbered 3.
template <rotation_size size, bool symmetric>
class bound_body final : public bound_body_motion {
  using bound = rigid_body_at<body_parts{true, !symmetric, true}, size, summed_noise>;
  using scalar = loop_scalar<strang, size>;
  using vector = vec<scalar, 3>;
  using algebra = typename rotations<size>::algebra;

 public:
  bound_body(const rigid_body& body, double dt, double radius)
      : bound_body_motion(body, dt, radius),
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

  POLHODE_FLATTEN void exp_action(const double* xi, const double* mu, double* out) const override {
    lanes_of<loop_pack>(mu, out, [&](const auto& x, int lane) {
      using S = typename std::remove_cvref_t<decltype(x)>::scalar;
      return algebra::exp_action(lane_rows<S>::template load<3>(xi + lane, block_lanes, 3), x);
    });
  }

  bool joins_passes() const override { return true; }
  POLHODE_FLATTEN void exp_of_generator(const double* mu, std::span<const step_noise> w, bool with_area,
                                        double* out) const override {
    const bool noisy = w[0].of != kind::none;
    with_area_noise(with_area && noisy ? &w[0] : nullptr, [&](auto area) {
      with_body<loop_pack>(w[0], [&](const auto& body, auto noise) {
        for (const auto& one : w)
          lanes_of<loop_pack>(std::exchange(mu, out), out, [&](const auto& x, int lane) {
            return algebra::exp_action(area(one, lane, body.generator_over(x, noise(one, lane))), x);
          });
      });
    });
  }
  POLHODE_FLATTEN void generator_of_turned(const double* xi, const double* mu, const step_noise& w,
                                           double* out) const override {
    with_body<loop_pack>(w, [&](const auto& body, auto noise) {
      lanes_of<loop_pack>(mu, out, [&](const auto& x, int lane) {
        return body.generator_over(algebra::exp_action(load_loop(xi + lane), x), noise(w, lane));
      });
    });
  }
  POLHODE_FLATTEN void exp_of_sum(std::span<const double> c, const double* const* x, const step_noise* w,
                                  const double* mu, double* out) const override {
    const auto with_terms = [&](auto sum) {
      with_area_noise(w, [&](auto area) {
        lanes_of<loop_pack>(mu, out, [&](const auto& y, int lane) {
          return algebra::exp_action(w == nullptr ? sum(lane) : area(*w, lane, sum(lane)), y);
        });
      });
    };
    const auto term = [&](std::size_t k) {
      return [a = loop_pack(c[k]), rows = x[k]](int lane) { return a * load_loop(rows + lane); };
    };
    if (c.size() == 1) return with_terms(term(0));
    const auto two = [a = term(0), b = term(1)](int lane) { return a(lane) + b(lane); };
    if (c.size() == 2) return with_terms(two);
    with_terms([=, last = term(2)](int lane) { return two(lane) + last(lane); });
  }
  POLHODE_FLATTEN void noise_after_free_flow(const double* mu, flow_time t, std::span<const step_noise> w,
                                             double* out) const override {
    if (symmetric || t.parts != 1 || !turns_ || !dissipates()) {
      for (const auto& one : w) {
        free_flow(std::exchange(mu, out), t, out);
        damped_noise_flow(out, one, out);
      }
      return;
    }
    step_after_step(mu, w, out, [whole = whole_](const auto& body, const vector& x, const auto& noise) {
      return damped(body, whole.free_flow(x, whole_step{}), noise);
    });
  }
  POLHODE_FLATTEN void noise_after_first_turn(const double* mu, flow_time t, std::span<const step_noise> w,
                                              double* out) const override {
    if (symmetric || t.parts != 1 || !turns_ || !dissipates()) {
      for (const auto& one : w) {
        first_turn(std::exchange(mu, out), t, out);
        turned_noise_flow(out, one, out);
      }
      return;
    }
    step_after_step(mu, w, out, [](const auto& body, const vector& x, const auto& noise) {
      const half_step half;
      const auto turned = body.last_turn(body.first_turn(x, whole_step{}), half);
      return body.last_turn(damped(body, turned, noise), half);
    });
  }

  POLHODE_FLATTEN void free_flow(const double* mu, flow_time t, double* out) const override {
    const auto flow = [body = whole_](const vector& x, auto part) { return body.free_flow(x, part); };
    if (!turns_) return lanes_of<pack>(mu, out, [](const auto& x, int) { return x; });
    if (t.parts == 1) return lanes_of<scalar>(mu, out, [&](const vector& x, int) { return flow(x, whole_step{}); });
    if (t.parts == 2) return lanes_of<scalar>(mu, out, [&](const vector& x, int) { return flow(x, half_step{}); });
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
    if (w.of == kind::none) return dissipation_flow(mu, {dt(), 1}, out);
    if (!dissipates()) return noise_flow(mu, w, out);
    with_noise(w, [&](const auto& body, auto noise) {
      numbered_lanes(mu, out, [&](const vector& x, int lane) { return body.damped_noise_flow(x, noise(lane)); });
    });
  }
  POLHODE_FLATTEN void turned_noise_flow(const double* mu, const step_noise& w, double* out) const override {
    if (!dissipates() || symmetric) return bound_body_motion::turned_noise_flow(mu, w, out);
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

  static vec<loop_pack, 3> load_loop(const double* at) { return lane_rows<loop_pack>::load<3>(at, block_lanes, 3); }

  template <class S, class F>
  static void lanes_of(const double* mu, double* out, F f) {
#pragma GCC unroll 1
    for (int lane = 0; lane < block_lanes; lane += lane_rows<S>::width)
      lane_rows<S>::store(f(lane_rows<S>::template load<3>(mu + lane, block_lanes, 3), lane), out + lane, block_lanes);
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

  /// f(area), area(noise, lane, xi) = xi and the area's part; of no noise xi as it is.
  template <class F>
  void with_area_noise(const step_noise* w, F f) const {
    if (w == nullptr) return f([](const step_noise&, int, const auto& xi) { return xi; });
    if (w->of == kind::shared)
      return f([](const step_noise& one, int, const vec<loop_pack, 3>& xi) {
        return xi + detail::lifted<vec<loop_pack, 3>>(one.rows + 3, 3);
      });
    f([s = rigid_body(system())](const step_noise& one, int lane, const vec<loop_pack, 3>& xi) {
      return xi + s.area_noise(load_loop(one.area + lane));
    });
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
      lanes_of<pack>(mu, out, [](const auto& x, int) { return x; });
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

/// For states on the orbit of the momentum.
inline std::shared_ptr<const face> bound_face_of(const rigid_body& body, double radius, double dt) {
  const auto made = [&]<rotation_size size>() -> std::shared_ptr<const face> {
    if (parts_of(body).last_turn) return std::make_shared<bound_body<size, false>>(body, dt, radius);
    return std::make_shared<bound_body<size, true>>(body, dt, radius);
  };
  switch (rotation_size_of(body, radius, dt)) {
    case rotation_size::tiny:
      if (parts_of(body).dissipation) return made.template operator()<rotation_size::tiny>();
      [[fallthrough]];
    case rotation_size::small: return made.template operator()<rotation_size::small>();
    case rotation_size::moderate: return made.template operator()<rotation_size::moderate>();
    default: return made.template operator()<rotation_size::any>();
  }
}

}  // namespace polhode
