// SPDX-License-Identifier: Apache-2.0
// The symbols on which a scheme's step runs when it is taped: a scalar, vectors of it, and a system whose functions
// write operations. The `step` of a scheme's header is instantiated for them like for any other scalar and system.
//
// A vector is a linear form of registers. What has a name is computed where it is first used; what has none with what
// uses it, so that sums and motions in a row take one pass.
#pragma once

#include <algorithm>
#include <concepts>
#include <stdexcept>
#include <utility>
#include <vector>

#include <polhode/schemes/scheme_info.hpp>

#include "ensemble/tapes/tape_recorder.hpp"
#include "ensemble/tapes/taped_traits.hpp"

namespace polhode {

/// A number in each lane, or one for all.
class taped {
 public:
  taped() = default;
  taped(double constant) : constant_(constant) {}  // NOLINT: a constant is a number
  taped(tape_symbol of, int row) : of_(std::move(of)), row_(row) {}

  bool is_constant() const { return !of_; }
  double constant() const { return constant_; }
  int row() const { return is_constant() ? tape_instruction::constant : of_->at + row_; }
  tape_recorder* recorder() const { return of_ ? &of_->recorder : nullptr; }

 private:
  double constant_ = 0;
  tape_symbol of_;
  int row_ = 0;
};

/// A truth value in each lane.
struct taped_mask {
  taped number;
};

namespace detail {

/// out = op(a, …), numbers; `out` is a new one where none is given.
template <class... Numbers>
taped written(tape_op op, const Numbers&... in) {
  tape_recorder* recorder = nullptr;
  tape_instruction i{.op = op};
  const auto add = [&](const taped& x) {
    if (recorder == nullptr) recorder = x.recorder();
    i.in[static_cast<std::size_t>(i.operands)] = x.row();
    i.constants[static_cast<std::size_t>(i.operands++)] = x.constant();
  };
  (add(in), ...);
  if (recorder == nullptr) throw std::logic_error("a step computes with constants what it has to compute beforehand");
  const auto out = recorder->number();
  i.out = out->at;
  recorder->write(i);
  return {out, 0};
}

}  // namespace detail

inline taped operator+(const taped& a, const taped& b) { return detail::written(tape_op::add, a, b); }
inline taped operator-(const taped& a, const taped& b) { return detail::written(tape_op::subtract, a, b); }
inline taped operator*(const taped& a, const taped& b) { return detail::written(tape_op::multiply, a, b); }
inline taped operator/(const taped& a, const taped& b) { return detail::written(tape_op::divide, a, b); }
inline taped operator-(const taped& a) { return detail::written(tape_op::subtract, taped(0.0), a); }
inline taped square_root(const taped& a) { return detail::written(tape_op::square_root, a); }
inline taped magnitude(const taped& a) { return detail::written(tape_op::magnitude, a); }
inline taped_mask operator<(const taped& a, const taped& b) { return {detail::written(tape_op::less, a, b)}; }
inline taped_mask operator<=(const taped& a, const taped& b) { return {detail::written(tape_op::less_equal, a, b)}; }
inline taped_mask operator>(const taped& a, const taped& b) { return b < a; }
inline taped_mask operator>=(const taped& a, const taped& b) { return b <= a; }
inline taped_mask operator==(const taped& a, const taped& b) { return {detail::written(tape_op::equal, a, b)}; }
inline taped_mask operator&&(const taped_mask& a, const taped_mask& b) {
  return {detail::written(tape_op::both, a.number, b.number)};
}
inline taped_mask operator||(const taped_mask& a, const taped_mask& b) {
  return {detail::written(tape_op::either, a.number, b.number)};
}
inline taped_mask operator!(const taped_mask& a) { return {detail::written(tape_op::negate, a.number)}; }
inline taped select(const taped_mask& m, const taped& yes, const taped& no) {
  return detail::written(tape_op::select, m.number, yes, no);
}
inline bool any(const taped&, const taped_mask& m) { return m.number.recorder()->any(m.number.row()); }

/// A vector: the linear form sum c_i x_i.
template <int N>
struct vec<taped, N> {
  using scalar = taped;
  int size = 0;  ///< rows: components, and those of tangents

  vec() = default;
  explicit vec(tape_symbol x) : size(x->rows), form_{{1, std::move(x)}} {}
  vec(const vec&) = default;
  vec(vec&&) = default;
  vec& operator=(const vec& other) {
    if (!other.form_.empty()) other.symbol();
    size = other.size;
    form_ = other.form_;
    return *this;
  }

  /// Its register.
  const tape_symbol& symbol() const {
    if (form_.empty()) throw std::logic_error("a step uses a vector that it has given no value");
    if (form_.size() != 1 || form_[0].c != 1 || form_[0].x->at == tape_value::not_computed) {
      tape_symbol x = form_[0].x->recorder.computed(form_);
      form_.clear();  // before its registers are used again
      form_.push_back({1, std::move(x)});
    }
    return form_[0].x;
  }
  const linear_form& form() const { return form_; }

  /// Of component k: the value, and a place that can be assigned to.
  taped operator[](int k) const { return {symbol(), k}; }
  class component {
   public:
    component(vec& of, int k) : of_(of), k_(k) {}
    operator taped() const { return std::as_const(of_)[k_]; }
    component& operator=(const taped& x) {
      of_.own()->recorder.assign(of_[k_].row(), x.row(), x.constant());
      return *this;
    }
    component& operator=(const component& other) { return *this = taped(other); }
    int row() const { return taped(*this).row(); }

   private:
    vec& of_;
    int k_;
  };
  component operator[](int k) { return {*this, k}; }

  friend vec operator+(const vec& a, const vec& b) { return added(named(a), 1, named(b)); }
  friend vec operator+(vec&& a, const vec& b) { return added(std::move(a), 1, named(b)); }
  friend vec operator+(const vec& a, vec&& b) { return added(named(a), 1, std::move(b)); }
  friend vec operator+(vec&& a, vec&& b) { return added(std::move(a), 1, std::move(b)); }
  friend vec operator-(const vec& a, const vec& b) { return added(named(a), -1, named(b)); }
  friend vec operator-(vec&& a, const vec& b) { return added(std::move(a), -1, named(b)); }
  friend vec operator-(const vec& a, vec&& b) { return added(named(a), -1, std::move(b)); }
  friend vec operator-(vec&& a, vec&& b) { return added(std::move(a), -1, std::move(b)); }
  friend vec operator-(const vec& a) { return times(-1, named(a)); }
  friend vec operator-(vec&& a) { return times(-1, std::move(a)); }
  friend vec operator*(const taped& s, const vec& a) { return times(s, named(a)); }
  friend vec operator*(const taped& s, vec&& a) { return times(s, std::move(a)); }
  friend vec operator+(vec a, zero_vector) { return a; }
  friend vec operator+(zero_vector, vec a) { return a; }

 private:
  /// What has a name is computed.
  static vec named(const vec& a) {
    a.symbol();
    return a;
  }
  static vec added(vec a, double c, const vec& b) {
    for (const auto& t : b.form_) a.form_.push_back({c * t.c, t.x});
    if (a.size == 0) a.size = b.size;
    if (a.form_.size() > tape_instruction::most_operands) a.symbol();
    return a;
  }
  static vec times(const taped& s, vec a) {
    if (s.is_constant()) {
      for (auto& t : a.form_) t.c *= s.constant();
      return a;
    }
    const auto x = a.symbol();
    const auto out = x->recorder.fresh(x->rows, x->on_tangents);
    x->recorder.write({.op = tape_op::scale, .operands = 2, .rows = x->rows, .out = out->at, .in = {s.row(), x->at}});
    return vec(out);
  }
  /// A register that no other vector has.
  tape_symbol own() {
    if (form_.size() != 1 || form_[0].x.use_count() > 1 || form_[0].c != 1) {
      const auto from = symbol();
      auto& recorder = from->recorder;
      const auto to = recorder.fresh(from->rows, from->on_tangents);
      recorder.write({.op = tape_op::combine,
                      .operands = 1,
                      .rows = from->rows,
                      .out = to->at,
                      .in = {from->at},
                      .constants = {1}});
      form_ = {{1, to}};
    }
    return form_[0].x;
  }

  mutable linear_form form_;
};

template <int N>
vec<taped, N> select(const taped_mask& m, const vec<taped, N>& yes, const vec<taped, N>& no) {
  const auto a = yes.symbol(), b = no.symbol();
  const auto out = a->recorder.fresh(a->rows, a->on_tangents);
  a->recorder.write({.op = tape_op::select_rows,
                     .operands = 3,
                     .rows = a->rows,
                     .out = out->at,
                     .in = {m.number.row(), a->at, b->at}});
  return vec<taped, N>(out);
}

/// A matrix that acts on a state: its rows are components of the state alone.
template <int N>
struct vec<vec<taped, N>, N> {
  tape_symbol symbol;
};

template <int N>
taped dot(const vec<taped, N>& a, const vec<taped, N>& b) {
  const auto x = a.symbol(), y = b.symbol();
  const auto out = x->recorder.number();
  x->recorder.write({.op = tape_op::dot, .operands = 2, .rows = x->rows, .out = out->at, .in = {x->at, y->at}});
  return {out, 0};
}
template <int N>
vec<taped, N> times(const matrix<taped, N>& m, const vec<taped, N>& x) {
  const auto at = x.symbol();
  const auto out = at->recorder.fresh(at->rows);
  at->recorder.write(
      {.op = tape_op::times, .operands = 2, .rows = at->rows, .out = out->at, .in = {m.symbol->at, at->at}});
  return vec<taped, N>(out);
}
/// (1 - slope / 2)^-1 (polhode/schemes/midpoint_solver.hpp).
template <quotient q, int N>
matrix<taped, N> inverse_derivative(const linearised<taped, N>& at) {
  auto& recorder = at.slope.symbol->recorder;
  const auto out = recorder.fresh(at.slope.symbol->rows);
  recorder.write({.op = tape_op::inverse_derivative,
                  .truncated = q == quotient::truncated,
                  .operands = 1,
                  .rows = recorder.components(),
                  .out = out->at,
                  .in = {at.slope.symbol->at}});
  return {out};
}
/// way -= back residual; the square of what is taken away.
template <int N>
taped correct(vec<taped, N>& way, const matrix<taped, N>& back, const vec<taped, N>& residual) {
  const auto from = way.symbol(), r = residual.symbol();
  auto& recorder = from->recorder;
  const auto square = recorder.number(), out = recorder.fresh(from->rows);
  recorder.write({.op = tape_op::correct,
                  .operands = 3,
                  .rows = from->rows,
                  .out = out->at,
                  .extra = square->at,
                  .in = {from->at, back.symbol->at, r->at}});
  way = vec<taped, N>(out);
  return {square, 0};
}

/// The player of the tape holds the increment: what stands in it is between the loop and the system's face.
template <int M>
struct wiener<taped, M> {
  double dt = 0;
};
struct taped_area {
  tape_recorder* recorder = nullptr;
};
template <int M>
struct wiener_levy<taped, M> : wiener<taped, M> {
  taped_area area;
};

namespace detail {

/// out = op(x, …), states; the instruction's other members as given.
template <int N, class... Vectors>
vec<taped, N> asked(tape_instruction i, const vec<taped, N>& first, const Vectors&... others) {
  const auto x = first.symbol();
  const auto add = [&](const vec<taped, N>& v) { i.in[static_cast<std::size_t>(i.operands++)] = v.symbol()->at; };
  (add(first), ..., add(others));
  auto& recorder = x->recorder;
  const auto out = recorder.fresh(x->rows, x->on_tangents);
  i.on_tangents = x->on_tangents;
  i.out = out->at;
  recorder.write(i);
  return vec<taped, N>(out);
}

}  // namespace detail

template <int N, bool matrices>
struct taped_algebra {
  static constexpr int dimension = N;
  using vector = vec<taped, N>;

  // For the concepts, which ask with doubles: declared and never called.
  template <class S>
  static vec<S, N> bracket(const vec<S, N>&, const vec<S, N>&);
  template <class S>
  static vec<S, N> coad(const vec<S, N>&, const vec<S, N>&);
  template <class S>
  static vec<S, N> exp_action(const vec<S, N>&, const vec<S, N>&);
  template <class S>
  static vec<S, N> cayley_action(const vec<S, N>&, const vec<S, N>&);
  template <class S>
  static vec<S, N> dexp_inv(const vec<S, N>&, const vec<S, N>&);
  template <class S>
  static vec<S, N> orbit_projection(const vec<S, N>&, const vec<S, N>&);
  template <class S>
  requires matrices static vec<S, N> sandwich(const vec<S, N>&, const vec<S, N>&);
  template <class S>
  static void casimirs(const vec<S, N>&);

  static vector bracket(const vector& a, const vector& b) { return detail::asked({.op = tape_op::bracket}, a, b); }
  static vector coad(const vector& a, const vector& b) { return detail::asked({.op = tape_op::coad}, a, b); }
  static zero_vector coad(zero_vector, const vector&) { return {}; }
  static vector exp_action(const vector& a, const vector& b) {
    return detail::asked({.op = tape_op::exp_action}, a, b);
  }
  static vector exp_action(zero_vector, const vector& b) { return b; }
  static vector cayley_action(const vector& a, const vector& b) {
    return detail::asked({.op = tape_op::cayley_action}, a, b);
  }
  static vector dexp_inv(const vector& a, const vector& b) { return detail::asked({.op = tape_op::dexp_inv}, a, b); }
  static vector orbit_projection(const vector& a, const vector& b) {
    return detail::asked({.op = tape_op::orbit_projection}, a, b);
  }
  static vector sandwich(const vector& a, const vector& b) requires matrices {
    return detail::asked({.op = tape_op::sandwich}, a, b);
  }
};

/// Any system with these traits.
template <taped_traits traits>
struct taped_system {
  static constexpr int dimension = traits.components, channels = -1;
  static constexpr bool approximate_dissipation = !traits.exact_dissipation;
  static constexpr bool silent = traits.noise == taped_noise::none,
                        constant = silent || traits.noise == taped_noise::constant,
                        varying = traits.noise == taped_noise::varying;
  using algebra = taped_algebra<dimension, traits.matrices>;
  using vector = vec<taped, dimension>;
  using increment = wiener<taped, channels>;

  /// The step size for which the noise vectors are those of constant_noise::weak_order_two; 0: they are the scene's.
  double weak_order_two_at = 0;
  struct other_noise {
    double dt;
  };
  other_noise weak_order_two(double dt) const { return {dt}; }
  taped_system with_noise(other_noise n) const { return {n.dt}; }

  // For the concepts, which ask with doubles: declared and never called.
  template <class S>
  using state = vec<S, dimension>;
  template <class S>
  state<S> generator(const state<S>&) const;
  template <class S>
  state<S> ito_drift(const state<S>&) const;
  template <class S>
  S energy(const state<S>&) const;
  template <class S>
  requires constant state<S> noise(const vec<S, channels>&)
  const;
  template <class S>
  requires constant state<S> area_noise(const vec<S, pairs_of<channels>>&)
  const;
  template <class S>
  requires(!constant) state<S> noise_at(const state<S>&, const wiener<S, channels>&)
  const;
  template <class S>
  requires varying state<S> area_noise_at(const state<S>&, const vec<S, pairs_of<channels>>&)
  const;
  template <class S>
  requires varying state<S> noise_slope_at(const state<S>&, const wiener<S, channels>&, const state<S>&)
  const;
  template <class S>
  requires(traits.flows) state<S> free_flow(const state<S>&, double)
  const;
  template <class S>
  requires(traits.flows) state<S> dissipation_flow(const state<S>&, double)
  const;
  template <class S>
  requires(traits.turns) state<S> first_turn(const state<S>&, double)
  const;
  template <class S>
  requires(traits.turns) state<S> last_turn(const state<S>&, double)
  const;

  // What a step asks of it (polhode/systems/lie_poisson.hpp).
  vector generator_over(const vector& mu, const increment&) const { return asked(tape_op::generator, mu); }
  vector drift_over(const vector& mu, const increment&) const { return asked(tape_op::drift, mu); }
  /// A motion is computed where it is used.
  vector motion_over(const vector& mu, const increment&) const {
    const auto waits = [](const auto& t) { return t.x->at == tape_value::not_computed; };
    if (std::ranges::any_of(mu.form(), waits)) mu.symbol();
    const auto& x = *mu.form().at(0).x;
    auto out = std::make_shared<tape_value>(x.recorder, tape_value::not_computed, x.rows);
    out->on_tangents = x.on_tangents;
    out->point = mu.form();
    return vector(std::move(out));
  }
  linearised<taped, dimension> linearised_motion_over(const vector& mu, const increment&) const
      requires(dimension > 0) {
    return linearised_by(tape_op::linearised_motion, mu);
  }
  vector contracted_motion_over(const vector& m, const increment&) const requires(traits.matrices) {
    return asked(tape_op::contracted_motion, m);
  }
  linearised<taped, dimension> linearised_contracted_motion_over(const vector& m, const increment&) const
      requires(dimension > 0 && traits.matrices) {
    return linearised_by(tape_op::linearised_contracted_motion, m);
  }
  auto ito_drift(const vector& mu) const { return unless_silent(tape_op::ito_drift, mu); }
  auto noise_at(const vector& mu, const increment&) const { return unless_silent(tape_op::noise, mu); }
  auto noise_twice_over(const vector& mu, const increment&) const { return unless_silent(tape_op::noise_twice, mu); }
  vector noise_slope_at(const vector& mu, const increment&, const vector& by) const requires varying {
    return detail::asked({.op = tape_op::noise_slope}, mu, by);
  }
  auto area_noise(const taped_area& area) const requires constant {
    if constexpr (silent) {
      return zero_vector{};
    } else {
      const auto out = area.recorder->fresh(area.recorder->rows());
      area.recorder->write({.op = tape_op::area_noise, .out = out->at});
      return vector(out);
    }
  }
  vector area_noise_at(const vector& mu, const taped_area&) const requires varying {
    return asked(tape_op::area_noise, mu);
  }
  vector noise_flow(const vector& mu, const increment&) const { return silent ? mu : asked(tape_op::noise_flow, mu); }
  vector damped_noise_flow(const vector& mu, const increment&) const { return asked(tape_op::damped_noise_flow, mu); }
  vector turned_noise_flow(const vector& mu, const increment&) const requires(traits.turns) {
    return asked(tape_op::turned_noise_flow, mu);
  }
  template <class Time>
  requires(traits.flows) vector free_flow(const vector& mu, Time t)
  const { return flow(tape_op::free_flow, mu, t); }
  template <class Time>
  requires(traits.flows) vector dissipation_flow(const vector& mu, Time t)
  const { return flow(tape_op::dissipation_flow, mu, t); }
  template <class Time>
  requires(traits.turns) vector first_turn(const vector& mu, Time t)
  const { return flow(tape_op::first_turn, mu, t); }
  template <class Time>
  requires(traits.turns) vector last_turn(const vector& mu, Time t)
  const { return flow(tape_op::last_turn, mu, t); }

 private:
  static vector asked(tape_op op, const vector& mu) { return detail::asked({.op = op}, mu); }
  static linearised<taped, dimension> linearised_by(tape_op op, const vector& mu) {
    const auto at = mu.symbol();
    auto& recorder = at->recorder;
    const int n = recorder.components();
    const auto value = recorder.fresh(n), slope = recorder.fresh(n * n);
    recorder.write({.op = op, .operands = 1, .out = value->at, .extra = slope->at, .in = {at->at}});
    return {vector(value), {slope}};
  }
  static auto unless_silent(tape_op op, const vector& mu) {
    if constexpr (silent)
      return zero_vector{};
    else
      return asked(op, mu);
  }
  template <int n>
  static constexpr int parts(part_of_step<n>) {
    return n;
  }
  static constexpr int parts(double) { return 0; }
  template <class Time>
  static vector flow(tape_op op, const vector& mu, Time t) {
    return detail::asked({.op = op, .parts = parts(t), .constants = {static_cast<double>(t)}}, mu);
  }
};

/// A map of the state with its derivative by the components: the map itself, with two of them as tangents at a time.
template <class Map, int N, int M>
linearised<taped, N> derivative_of(Map map, const vec<taped, N>& mu, const wiener<taped, M>& w) {
  constexpr int at_once = 2;  // the tangents of a face
  const auto x = mu.symbol();
  auto& recorder = x->recorder;
  const int n = recorder.components();
  const auto slope = recorder.fresh(n * n);
  for (int column = 0; column < n; column += at_once) {
    const auto seeded = recorder.fresh((1 + at_once) * n, true);
    recorder.write({.op = tape_op::seed, .operands = 1, .rows = n, .column = column, .out = seeded->at, .in = {x->at}});
    const auto moved = map(vec<taped, N>(seeded), w);
    recorder.write({.op = tape_op::differentiate,
                    .operands = 1,
                    .rows = n,
                    .column = column,
                    .out = slope->at,
                    .in = {moved.symbol()->at}});
  }
  return {map(mu, w), {slope}};
}

}  // namespace polhode
