// SPDX-License-Identifier: Apache-2.0
// A step of a scheme as the list of its operations on whole groups of lanes: written once for a system's size and a
// step size by running the scheme's own step on symbols (taped.hpp), played back step after step (tape_kernel.hpp).
//
// Operands are registers, some rows of lanes one after the other: states, matrices and, of one row, numbers. Truth
// values are numbers, 1 and 0. The first rows of all hold the state before and after the step.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string_view>
#include <vector>

namespace polhode {

enum class tape_op : std::uint8_t {
  // of a state, by the face
  generator,
  drift,
  motion,
  stage,
  noise,
  noise_slope,
  noise_twice,
  area_noise,
  ito_drift,
  linearised_motion,
  contracted_motion,
  linearised_contracted_motion,
  bracket,
  coad,
  exp_action,
  cayley_action,
  dexp_inv,
  orbit_projection,
  sandwich,
  free_flow,
  dissipation_flow,
  first_turn,
  last_turn,
  noise_flow,
  damped_noise_flow,
  turned_noise_flow,
  // two of them in one pass, where the face has that
  exp_of_generator,        ///< out = exp(generator(in_0)) in_0, with_area: + area_noise in the exponent
  generator_of_turned,     ///< out = generator(exp(in_0) in_1)
  exp_of_sum,              ///< out = exp(sum c_i in_i) in_k, k the last operand; with_area: likewise
  noise_after_free_flow,   ///< damped_noise_flow of what free_flow gives
  noise_after_first_turn,  ///< turned_noise_flow of what first_turn gives
  // of rows
  combine,             ///< out = sum c_i in_i, every row
  scale,               ///< out = (number in_0) in_1, every row
  select_rows,         ///< out = (number in_0) ? in_1 : in_2, every row
  seed,                ///< out: the components of in_0 with the unit vectors `column`, `column` + 1 as its tangents
  differentiate,       ///< columns `column`, `column` + 1 of the matrix out: the tangents of in_0
  inverse_derivative,  ///< the matrix out = (1 - in_0 / 2)^-1
  times,               ///< out = (matrix in_0) in_1
  correct,             ///< out = in_0 - c, c = (matrix in_1) in_2; the number extra = c.c
  dot,                 ///< the number out = in_0 . in_1
  // of numbers
  copy,
  add,
  subtract,
  multiply,
  divide,
  square_root,
  magnitude,
  less,
  less_equal,
  equal,
  both,
  either,
  negate,
  select,  ///< out = in_0 ? in_1 : in_2
};

inline constexpr int most_terms_of_exp = 3;

struct tape_instruction {
  static constexpr int most_operands = 6, constant = -1;
  tape_op op;
  bool on_tangents = false;  ///< asks the face of tangents, which `seed` begins
  bool truncated = false;    ///< of inverse_derivative: polhode::quotient
  bool with_area = false;
  int operands = 0;
  int rows = 0;    ///< of states, of a matrix or of both operands of dot: the components of one
  int column = 0;  ///< of a matrix
  int parts = 0;   ///< of a flow over the time constants[0]: flow_time
  // The first row of each register; constant: the number at its place in `constants`.
  int out = 0, extra = 0;
  std::array<int, most_operands> in{};
  std::array<double, most_operands> constants{};
};

/// Operations that follow each other without a question, and what comes next: the end of the step, or for either answer
/// to `any lane of this number is not 0` another piece.
struct tape_piece {
  std::vector<tape_instruction> code;
  bool ends = false;
  int question = 0;                                              ///< the row of the number
  int rows = 0;                                                  ///< of all registers up to here
  mutable std::array<std::atomic<const tape_piece*>, 2> next{};  ///< by the answer; null: not met yet
};

class tape_recorder;
/// The step itself, run on symbols: writes what it does into the recorder.
using recorded_step = std::function<void(tape_recorder&)>;

/// All pieces of a step that have been met. Answers that no run has given yet are recorded when one gives them; pieces
/// never change, so any number of threads may play a tape.
class tape {
 public:
  /// components, tangents: of a state. joins: whether its face takes two operations in one pass.
  tape(int components, int tangents, bool joins, recorded_step);

  const tape_piece& start() const {
    const auto* known = before_.next[true].load(std::memory_order_acquire);
    return known != nullptr ? *known : after(before_, {}, true);
  }
  /// What follows the piece, to which `answers` have led, after one answer more.
  const tape_piece& after(const tape_piece&, const std::vector<bool>& answers, bool answer) const;

  int rows() const { return components_ * (1 + tangents_); }  ///< of a state

 private:
  std::unique_ptr<tape_piece> record(const std::vector<bool>& answers) const;

  int components_, tangents_;
  bool joins_;
  recorded_step step_;
  tape_piece before_;  ///< the step; what follows it is its start
  mutable std::mutex recording_;
  mutable std::vector<std::unique_ptr<tape_piece>> pieces_;
};

/// A step; where its last flow merges with the first of the next, the first of several steps, those after it, and what
/// is left to do after the last.
struct step_tapes {
  std::shared_ptr<const tape> opening, following, closing;  ///< closing: none where nothing merges
};

/// What a scheme does with noise and without.
struct scheme_tapes {
  std::string_view scheme;
  step_tapes noisy, silent;
};

}  // namespace polhode
