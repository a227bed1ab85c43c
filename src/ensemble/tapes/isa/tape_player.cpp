// SPDX-License-Identifier: Apache-2.0
// Plays tapes on faces. An operation is one pass over the rows of a group of lanes; the registers of a step stay in the
// nearest cache.
#include <algorithm>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <polhode/increment.hpp>
#include <polhode/simd.hpp>
#include <polhode/solve.hpp>

#include "ensemble/faces/face.hpp"
#include "ensemble/lanes.hpp"
#include "ensemble/tapes/tape_kernel_entries.hpp"
#include "platform/work_counters.hpp"

namespace polhode {
namespace {

constexpr int width = static_cast<int>(pack::size());

pack load(const double* at) { return pack(at, stdx::element_aligned); }
void store(const pack& x, double* at) { x.copy_to(at, stdx::element_aligned); }

/// The registers of one thread.
struct workspace {
  lane_vector<double> states, registers, noise;
  std::vector<bool> answers;
};

/// One group of lanes.
class player {
 public:
  player(const face& f, const face* tangents, double* states, workspace& own)
      : face_(f), tangents_(tangents), states_(states), rows_(f.rows()), lanes_(f.lanes()), own_(own) {}

  /// Whether `play_in_a_row` takes its only operation.
  static bool is_one_operation(const tape& t) {
    const auto& start = t.start();
    if (!start.ends || start.code.size() != 1) return false;
    const auto op = start.code[0].op;
    return op == tape_op::exp_of_generator || op == tape_op::noise_after_free_flow ||
           op == tape_op::noise_after_first_turn;
  }
  void play_in_a_row(const tape& t, std::span<const step_noise> w) const { play_in_a_row(t.start().code[0], w); }

  void play(const tape& t, const step_noise& noise) {
    const auto& start = t.start();
    carry_out(start, noise);
    if (!start.ends) go_on(t, start, noise);
  }

 private:
  void carry_out(const tape_piece& piece, const step_noise& noise) {
    reserve(piece.rows);
    for (const auto& i : piece.code) carry_out(i, noise);
  }
  [[gnu::noinline]] void go_on(const tape& t, const tape_piece& start, const step_noise& noise) {
    own_.answers.clear();
    for (const auto* piece = &start; !piece->ends; carry_out(*piece, noise)) {
      const bool answer = any(at(piece->question));
      const auto* next = piece->next[answer].load(std::memory_order_acquire);
      if (next == nullptr) next = &t.after(*piece, own_.answers, answer);
      own_.answers.push_back(answer);
      piece = next;
    }
  }

  void reserve(int rows) {
    const auto size = static_cast<std::size_t>(rows) * static_cast<std::size_t>(lanes_);
    if (own_.registers.size() < size) own_.registers.resize(size);
    registers_ = own_.registers.data();
  }
  double* at(int row) const { return (row < rows_ ? states_ : registers_) + row * lanes_; }

  void carry_out(const tape_instruction& i, const step_noise& w) {
    const face& f = i.on_tangents ? *tangents_ : face_;
    double* out = at(i.out);
    const auto in = [&](std::size_t k) { return at(i.in[k]); };
    switch (i.op) {
      case tape_op::generator: return f.generator(in(0), w, out);
      case tape_op::drift: return f.drift(in(0), out);
      case tape_op::motion: return f.motion(in(0), w, out);
      case tape_op::stage: return f.stage(in(0), in(1), i.constants.data(), w, out);
      case tape_op::noise: return f.noise(in(0), w, out);
      case tape_op::noise_slope: return f.noise_slope(in(0), in(1), w, out);
      case tape_op::noise_twice: return f.noise_twice(in(0), w, out);
      case tape_op::area_noise: return f.area_noise(in(0), w, out);
      case tape_op::ito_drift: return f.ito_drift(in(0), out);
      case tape_op::linearised_motion: return f.linearised_motion(in(0), w, out, at(i.extra));
      case tape_op::contracted_motion: return f.contracted_motion(in(0), w, out);
      case tape_op::linearised_contracted_motion: return f.linearised_contracted_motion(in(0), w, out, at(i.extra));
      case tape_op::bracket: return f.bracket(in(0), in(1), out);
      case tape_op::coad: return f.coad(in(0), in(1), out);
      case tape_op::exp_action: return f.exp_action(in(0), in(1), out);
      case tape_op::cayley_action: return f.cayley_action(in(0), in(1), out);
      case tape_op::dexp_inv: return f.dexp_inv(in(0), in(1), out);
      case tape_op::orbit_projection: return f.orbit_projection(in(0), in(1), out);
      case tape_op::sandwich: return f.sandwich(in(0), in(1), out);
      case tape_op::free_flow: return f.free_flow(in(0), time_of(i), out);
      case tape_op::dissipation_flow: return f.dissipation_flow(in(0), time_of(i), out);
      case tape_op::first_turn: return f.first_turn(in(0), time_of(i), out);
      case tape_op::last_turn: return f.last_turn(in(0), time_of(i), out);
      case tape_op::noise_flow: return f.noise_flow(in(0), w, out);
      case tape_op::damped_noise_flow: return f.damped_noise_flow(in(0), w, out);
      case tape_op::turned_noise_flow: return f.turned_noise_flow(in(0), w, out);
      case tape_op::exp_of_generator: return f.exp_of_generator(in(0), std::span(&w, 1), i.with_area, out);
      case tape_op::generator_of_turned: return f.generator_of_turned(in(0), in(1), w, out);
      case tape_op::exp_of_sum: return exp_of_sum(i, w, out);
      case tape_op::noise_after_free_flow: return f.noise_after_free_flow(in(0), time_of(i), std::span(&w, 1), out);
      case tape_op::noise_after_first_turn: return f.noise_after_first_turn(in(0), time_of(i), std::span(&w, 1), out);
      case tape_op::combine: return combine(i, out);
      case tape_op::scale: return scale(in(0), in(1), i.rows, out);
      case tape_op::select_rows: return select_rows(in(0), in(1), in(2), i.rows, out);
      case tape_op::seed: return seed(in(0), i.rows, i.column, out);
      case tape_op::differentiate: return differentiate(in(0), i.rows, i.column, out);
      case tape_op::inverse_derivative: return inverse_derivative(i, out);
      case tape_op::times: return times(in(0), in(1), i.rows, out);
      case tape_op::correct: return correct(i, out);
      case tape_op::dot: return dot(in(0), in(1), i.rows, out);
      default: return numbers(i, out);
    }
  }

  void exp_of_sum(const tape_instruction& i, const step_noise& w, double* out) const {
    std::array<const double*, tape_instruction::most_operands> x{};
    const auto terms = static_cast<std::size_t>(i.operands - 1);
    for (std::size_t k = 0; k < terms; ++k) x[k] = at(i.in[k]);
    face_.exp_of_sum({i.constants.data(), terms}, x.data(), i.with_area ? &w : nullptr, at(i.in[terms]), out);
  }

  /// Steps that are one operation each, in a row.
  void play_in_a_row(const tape_instruction& i, std::span<const step_noise> w) const {
    const auto t = time_of(i);
    if (i.op == tape_op::exp_of_generator) return face_.exp_of_generator(states_, w, i.with_area, states_);
    if (i.op == tape_op::noise_after_free_flow) return face_.noise_after_free_flow(states_, t, w, states_);
    face_.noise_after_first_turn(states_, t, w, states_);
  }

  static flow_time time_of(const tape_instruction& i) { return {i.constants[0], i.parts}; }

  bool any(const double* truth) const {
    bool found = false;
    for (int lane = 0; lane < lanes_; lane += width) found = found || stdx::any_of(load(truth + lane) != pack(0.0));
    return found;
  }

  // Rows.

  template <int terms>
  void sum(const tape_instruction& i, double* out) const {
    std::array<const double*, terms> x;
    std::array<pack, terms> c;
    for (std::size_t k = 0; k < terms; ++k) {
      x[k] = at(i.in[k]);
      c[k] = pack(i.constants[k]);
    }
    const int size = i.rows * lanes_;
#pragma GCC unroll 2
    for (int lane = 0; lane < size; lane += width) {
      pack s = c[0] * load(x[0] + lane);
      for (std::size_t k = 1; k < terms; ++k) s += c[k] * load(x[k] + lane);
      store(s, out + lane);
    }
  }
  void combine(const tape_instruction& i, double* out) const {
    switch (i.operands) {
      case 1: return sum<1>(i, out);
      case 2: return sum<2>(i, out);
      case 3: return sum<3>(i, out);
      case 4: return sum<4>(i, out);
      case 5: return sum<5>(i, out);
      default: return sum<6>(i, out);
    }
  }
  void scale(const double* number, const double* x, int rows, double* out) const {
    for (int row = 0; row < rows; ++row)
      for (int lane = 0; lane < lanes_; lane += width)
        store(load(number + lane) * load(x + row * lanes_ + lane), out + row * lanes_ + lane);
  }
  void select_rows(const double* truth, const double* yes, const double* no, int rows, double* out) const {
    for (int lane = 0; lane < lanes_; lane += width) {
      const auto holds = load(truth + lane) != pack(0.0);
      for (int row = 0; row < rows; ++row) {
        const int at = row * lanes_ + lane;
        store(polhode::select(holds, load(yes + at), load(no + at)), out + at);
      }
    }
  }
  void dot(const double* a, const double* b, int rows, double* out) const {
    for (int lane = 0; lane < lanes_; lane += width) {
      pack s = load(a + lane) * load(b + lane);
      for (int row = 1; row < rows; ++row) s += load(a + row * lanes_ + lane) * load(b + row * lanes_ + lane);
      store(s, out + lane);
    }
  }
  void seed(const double* mu, int n, int column, double* out) const {
    std::copy_n(mu, n * lanes_, out);
    std::fill_n(out + n * lanes_, (rows_of_tangents() - n) * lanes_, 0.0);
    for (int t = 0; t < tangents_->tangents() && column + t < n; ++t)
      std::fill_n(out + ((1 + t) * n + column + t) * lanes_, lanes_, 1.0);
  }
  void differentiate(const double* moved, int n, int column, double* slope) const {
    for (int t = 0; t < tangents_->tangents() && column + t < n; ++t)
      for (int row = 0; row < n; ++row)
        std::copy_n(moved + ((1 + t) * n + row) * lanes_, lanes_, slope + (row * n + column + t) * lanes_);
  }
  int rows_of_tangents() const { return tangents_->rows(); }

  // Matrices, [row][column][lane]. A state with tangents is a vector after the other.

  /// f(size): as a constant where steps are taken by Newton's method throughout.
  template <class F>
  static void at_size(int n, F f) {
    if (n == 3) return f(std::integral_constant<int, 3>{});
    if (n == 6) return f(std::integral_constant<int, 6>{});
    f(n);
  }
  /// Row `row` of the matrix times the vector, in one pack.
  template <class Size>
  pack row_times(const double* m, int row, const double* x, Size n) const {
    pack y = load(m + row * n * lanes_) * load(x);
    for (int k = 1; k < n; ++k) y += load(m + (row * n + k) * lanes_) * load(x + k * lanes_);
    return y;
  }
  void times(const double* m, const double* x, int rows, double* out) const {
    at_size(face_.components(), [&](auto n) {
      for (int first = 0; first < rows; first += n)
        for (int lane = 0; lane < lanes_; lane += width)
          for (int row = 0; row < n; ++row)
            store(row_times(m + lane, row, x + first * lanes_ + lane, n), out + (first + row) * lanes_ + lane);
    });
  }
  void correct(const tape_instruction& i, double* out) const {
    const double *way = at(i.in[0]), *back = at(i.in[1]), *residual = at(i.in[2]);
    double* square = at(i.extra);
    at_size(face_.components(), [&](auto n) {
#pragma GCC unroll 1
      for (int lane = 0; lane < lanes_; lane += width) {
        pack sum(0.0);
        for (int first = 0; first < i.rows; first += n)
          for (int row = 0; row < n; ++row) {
            const pack c = row_times(back + lane, row, residual + first * lanes_ + lane, n);
            const int place = (first + row) * lanes_ + lane;
            store(load(way + place) - c, out + place);
            sum += c * c;
          }
        store(sum, square + lane);
      }
    });
  }
  void inverse_derivative(const tape_instruction& i, double* out) const {
    const double* slope = at(i.in[0]);
    const int n = i.rows;
    if (n == 3 && i.truncated) return inverse_of<3, quotient::truncated>(slope, out);
    if (n == 3) return inverse_of<3, quotient::exact>(slope, out);
    if (n == 6) return inverse_of<6, quotient::exact>(slope, out);
    inverse_derivative_by_lanes(slope, n, lanes_, out);
  }
  template <int n, quotient q>
  void inverse_of(const double* slope, double* out) const {
#pragma GCC unroll 1
    for (int lane = 0; lane < lanes_; lane += width) {
      matrix<pack, n> m;
      for (int row = 0; row < n; ++row)
        for (int k = 0; k < n; ++k)
          m[row][k] = pack(row == k ? 1.0 : 0.0) - pack(0.5) * load(slope + (row * n + k) * lanes_ + lane);
      m = inverse<q>(m);
      for (int row = 0; row < n; ++row)
        for (int k = 0; k < n; ++k) store(m[row][k], out + (row * n + k) * lanes_ + lane);
    }
  }

  // Numbers.

  /// A row of numbers, or one number for all lanes.
  struct operand {
    alignas(sizeof(pack)) std::array<double, width> constant;
    const double* at;
    int stride;
  };
  void read(const tape_instruction& i, std::size_t k, operand& x) const {
    const bool constant = i.in[k] == tape_instruction::constant;
    if (constant) x.constant.fill(i.constants[k]);
    x.at = constant ? x.constant.data() : at(i.in[k]);
    x.stride = constant ? 0 : 1;
  }
  template <class F>
  void each(const tape_instruction& i, double* out, F f) const {
    std::array<operand, 3> x;
    for (std::size_t k = 0; k < 3; ++k) read(i, k < static_cast<std::size_t>(i.operands) ? k : 0, x[k]);
#pragma GCC unroll 1
    for (int lane = 0; lane < lanes_; lane += width)
      store(
          f(load(x[0].at + x[0].stride * lane), load(x[1].at + x[1].stride * lane), load(x[2].at + x[2].stride * lane)),
          out + lane);
  }
  static pack truth(const pack::mask_type& m) { return select(m, pack(1.0), pack(0.0)); }
  void numbers(const tape_instruction& i, double* out) const {
    using x = const pack&;
    switch (i.op) {
      case tape_op::copy: return each(i, out, [](x a, x, x) { return a; });
      case tape_op::add: return each(i, out, [](x a, x b, x) { return a + b; });
      case tape_op::subtract: return each(i, out, [](x a, x b, x) { return a - b; });
      case tape_op::multiply: return each(i, out, [](x a, x b, x) { return a * b; });
      case tape_op::divide: return each(i, out, [](x a, x b, x) { return a / b; });
      case tape_op::square_root: return each(i, out, [](x a, x, x) { return square_root(a); });
      case tape_op::magnitude: return each(i, out, [](x a, x, x) { return magnitude(a); });
      case tape_op::less: return each(i, out, [](x a, x b, x) { return truth(a < b); });
      case tape_op::less_equal: return each(i, out, [](x a, x b, x) { return truth(a <= b); });
      case tape_op::equal: return each(i, out, [](x a, x b, x) { return truth(a == b); });
      case tape_op::both: return each(i, out, [](x a, x b, x) { return a * b; });
      case tape_op::either: return each(i, out, [](x a, x b, x) { return a + b - a * b; });
      case tape_op::negate: return each(i, out, [](x a, x, x) { return pack(1.0) - a; });
      case tape_op::select:
        return each(i, out, [](x m, x yes, x no) { return polhode::select(m != pack(0.0), yes, no); });
      default: throw std::logic_error("a tape has an operation that its player does not know");
    }
  }

  const face& face_;
  const face* tangents_;
  double *states_, *registers_ = nullptr;
  const int rows_, lanes_;
  workspace& own_;
};

workspace& workspace_of_thread() {
  static thread_local workspace own;
  return own;
}

/// Rows of a group of lanes, from and to rows of a block.
void gather(const double* from, int rows, int lanes, double* to) {
  for (int row = 0; row < rows; ++row) std::copy_n(from + row * block_lanes, lanes, to + row * lanes);
}
void scatter(const double* from, int rows, int lanes, double* to) {
  for (int row = 0; row < rows; ++row) std::copy_n(from + row * lanes, lanes, to + row * block_lanes);
}

constexpr int most_in_a_row = 8;  // their noise stays in the nearest cache

/// Increments of the view's steps for the lanes from `lane` on; of as many steps at a time as have a place.
class own_increments {
 public:
  own_increments(const face& f, const increment_view& view, workspace& own)
      : face_(f),
        view_(view),
        each_(static_cast<std::size_t>(f.noise_rows()) * static_cast<std::size_t>(f.lanes())),
        rows_(own.noise) {
    if (rows_.size() < most_in_a_row * each_) rows_.resize(most_in_a_row * each_);
  }
  step_noise operator()(std::int64_t step, int lane, std::size_t place) {
    const auto at = [&](const auto& all, int rows) {
      return all.empty() ? nullptr : all.data() + step * rows * block_lanes + lane;
    };
    const int channels = face_.channels();
    double* rows = rows_.data() + place * each_;
    face_.take({at(view_.dw, channels), at(view_.singles, channels), view_.scale}, rows);
    return {step_noise::kind::own, rows, at(view_.area, pairs_among(channels))};
  }

 private:
  const face& face_;
  const increment_view& view_;
  std::size_t each_;
  lane_vector<double>& rows_;
};

/// All steps of one group of lanes, the first of which is `lane`. noise(step, lane, place).
template <class Noise>
void run(const face& f, const face* tangents, const step_tapes& tapes, double* states, std::int64_t steps, piece p,
         Noise noise, int lane) {
  if (steps == 0) return;
  player group(f, tangents, states, workspace_of_thread());
  std::int64_t i = 0;
  if (p.first) group.play(*tapes.opening, noise(i++, lane, 0));
  if (player::is_one_operation(*tapes.following)) {
    std::array<step_noise, most_in_a_row> row;
    while (i < steps) {
      const auto count = static_cast<std::size_t>(std::min<std::int64_t>(most_in_a_row, steps - i));
      for (std::size_t k = 0; k < count; ++k) row[k] = noise(i++, lane, k);
      group.play_in_a_row(*tapes.following, std::span(row).first(count));
    }
  } else {
    for (; i < steps; ++i) group.play(*tapes.following, noise(i, lane, 0));
  }
  if (tapes.closing && p.last) group.play(*tapes.closing, {});
}

class played_kernel final : public kernel {
 public:
  explicit played_kernel(tape_on_faces of)
      : face_(std::move(of.values)), tangents_(std::move(of.tangents)), tapes_(std::move(of.tapes)) {}

  double dt() const override { return face_->dt(); }

  void advance(std::span<double> states, const increment_view& view, piece p) const override {
    if (view.silent())
      return advance(states, tapes_.silent, view.steps, p, [](std::int64_t, int, std::size_t) { return step_noise{}; });
    advance(states, tapes_.noisy, view.steps, p, own_increments(*face_, view, workspace_of_thread()));
  }

  shared_steps share(const increment_view& one_path) const override { return face_->share(one_path); }

  void advance(std::span<double> states, const shared_steps& shared, std::int64_t first_step, std::int64_t steps,
               piece p) const override {
    const double* rows = shared.table.data() + static_cast<std::size_t>(first_step) * shared.words;
    advance(states, tapes_.noisy, steps, p, [&](std::int64_t step, int, std::size_t) {
      return step_noise{step_noise::kind::shared, rows + static_cast<std::size_t>(step) * shared.words};
    });
  }

  void finish(std::span<double> states) const override {
    if (!tapes_.silent.closing) return;
    in_groups(states, [&](double* group, int) {
      player(*face_, nullptr, group, workspace_of_thread()).play(*tapes_.silent.closing, {});
    });
  }

 private:
  template <class Noise>
  void advance(std::span<double> states, const step_tapes& tapes, std::int64_t steps, piece p, Noise noise) const {
    count_path_steps(static_cast<std::uint64_t>(steps) * block_lanes, tapes_.scheme.data());
    in_groups(states,
              [&](double* group, int lane) { run(*face_, tangents_.get(), tapes, group, steps, p, noise, lane); });
  }

  /// f(states of a group, its first lane).
  template <class F>
  void in_groups(std::span<double> states, F f) const {
    const int lanes = face_->lanes(), rows = face_->rows();
    if (lanes == block_lanes) return f(states.data(), 0);
    auto& own = workspace_of_thread().states;
    own.resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(lanes));
    for (int lane = 0; lane < block_lanes; lane += lanes) {
      gather(states.data() + lane, rows, lanes, own.data());
      f(own.data(), lane);
      scatter(own.data(), rows, lanes, states.data() + lane);
    }
  }

  std::shared_ptr<const face> face_, tangents_;
  scheme_tapes tapes_;
};

class played_tangent_kernel final : public tangent_kernel {
 public:
  explicit played_tangent_kernel(tape_on_faces of) : face_(std::move(of.tangents)), tapes_(std::move(of.tapes)) {}

  double dt() const override { return face_->dt(); }

  void advance(std::span<double> states, std::span<double> tangents, const increment_view& view) const override {
    count_path_steps(static_cast<std::uint64_t>(view.steps) * block_lanes, tapes_.scheme.data());
    const int lanes = face_->lanes(), n = face_->components(), slopes = face_->rows() - n;
    auto& own = workspace_of_thread();
    own.states.resize(static_cast<std::size_t>(face_->rows() * lanes));
    for (int lane = 0; lane < block_lanes; lane += lanes) {
      double* group = own.states.data();
      gather(states.data() + lane, n, lanes, group);
      gather(tangents.data() + lane, slopes, lanes, group + n * lanes);
      if (view.silent())
        run(
            *face_, face_.get(), tapes_.silent, group, view.steps, {},
            [](std::int64_t, int, std::size_t) { return step_noise{}; }, lane);
      else
        run(*face_, face_.get(), tapes_.noisy, group, view.steps, {}, own_increments(*face_, view, own), lane);
      scatter(group, n, lanes, states.data() + lane);
      scatter(group + n * lanes, slopes, lanes, tangents.data() + lane);
    }
  }

 private:
  std::shared_ptr<const face> face_;
  scheme_tapes tapes_;
};

}  // namespace
}  // namespace polhode

extern "C" void POLHODE_ENTRY(polhode_tape_kernel_)(polhode::tape_on_faces of, std::unique_ptr<polhode::kernel>& out) {
  out = std::make_unique<polhode::played_kernel>(std::move(of));
}
extern "C" void POLHODE_ENTRY(polhode_tape_tangent_kernel_)(polhode::tape_on_faces of,
                                                            std::unique_ptr<polhode::tangent_kernel>& out) {
  out = std::make_unique<polhode::played_tangent_kernel>(std::move(of));
}
