// SPDX-License-Identifier: Apache-2.0
// Writes a tape while a step runs on symbols.
#pragma once

#include <memory>
#include <vector>

#include "ensemble/tapes/tape.hpp"

namespace polhode {

class tape_recorder;

/// What a symbol stands for: a register, or a motion whose computation waits for its use. The register is free again
/// when the last symbol that has it is gone.
class tape_value {
 public:
  struct term;
  static constexpr int not_computed = -1;

  tape_value(tape_recorder& by, int place, int count) : recorder(by), at(place), rows(count) {}
  tape_value(const tape_value&) = delete;
  ~tape_value();

  tape_recorder& recorder;
  int at;                     ///< the first row of its register; not_computed
  int rows;                   ///< of it
  bool on_tangents = false;   ///< seeded: lives on the face of tangents
  std::vector<term> point{};  ///< of a motion that is not computed yet: the form at which it is taken
};
using tape_symbol = std::shared_ptr<tape_value>;

/// One term c x of a linear form.
struct tape_value::term {
  double c;
  tape_symbol x;
};
using linear_form = std::vector<tape_value::term>;

class tape_recorder {
 public:
  /// Thrown out of the step where it asks what no answer is known to.
  struct unanswered {};

  tape_recorder(int components, int tangents, const std::vector<bool>& answers);

  int components() const { return components_; }
  int rows() const { return components_ * (1 + tangents_); }

  /// The state before the step; the state after it.
  tape_symbol start();
  void finish(const linear_form&);

  /// A free register of so many rows.
  tape_symbol fresh(int count, bool on_tangents = false);
  tape_symbol number() { return fresh(1); }

  void write(const tape_instruction& i) { code_.push_back(i); }
  /// The number in a row, or a constant, to another row.
  void assign(int to, int from, double constant);
  /// A form as one register; a motion in it is computed with it where that is one pass.
  tape_symbol computed(const linear_form&);

  /// Whether any lane of a truth value is not 0.
  bool any(int question);

  /// What has been written since the last question that was answered.
  std::unique_ptr<tape_piece> last_piece() const;

 private:
  friend class tape_value;
  struct place {
    int at, rows;
  };
  void release(place p) { free_.push_back(p); }
  tape_symbol combined(const linear_form&);
  tape_symbol combined_with_motion(linear_form, std::size_t which);
  void compute(tape_value& motion);

  int components_, tangents_;
  const std::vector<bool>& answers_;
  std::size_t asked_ = 0, piece_start_ = 0;
  bool ended_ = false;
  int question_ = 0, all_rows_ = 0;
  std::vector<tape_instruction> code_;
  std::vector<place> free_;
};

}  // namespace polhode
