// SPDX-License-Identifier: Apache-2.0
#include "ensemble/tapes/tape_recorder.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "ensemble/tapes/tape_joins.hpp"

namespace polhode {
namespace {

/// A stage in one pass needs the registers of the processor for three states.
constexpr int most_components_of_a_stage = 6;

bool is_motion(const tape_value::term& t) { return t.x->at == tape_value::not_computed; }

/// mu + c x.
struct point {
  tape_symbol mu, x;
  double c = 0;
};
/// Whether a form is of that kind.
bool is_point(const linear_form& form, point& out) {
  if (form.size() > 2) return false;
  const auto one = std::ranges::find(form, 1.0, &tape_value::term::c);
  if (one == form.end()) return false;
  out.mu = one->x;
  for (const auto& t : form)
    if (&t != &*one) {
      out.x = t.x;
      out.c = t.c;
    }
  return true;
}

}  // namespace

tape_value::~tape_value() {
  if (at != not_computed) recorder.release({at, rows});
}

tape_recorder::tape_recorder(int components, int tangents, const std::vector<bool>& answers)
    : components_(components), tangents_(tangents), answers_(answers) {}

tape_symbol tape_recorder::start() { return fresh(rows()); }

tape_symbol tape_recorder::fresh(int count, bool on_tangents) {
  const auto same = std::ranges::find(free_.rbegin(), free_.rend(), count, &place::rows);
  int at = all_rows_;
  if (same != free_.rend()) {
    at = same->at;
    free_.erase(std::next(same).base());
  } else {
    all_rows_ += count + (count % 8 == 0 ? 1 : 0);  // not every register at the same place of a page
  }
  auto out = std::make_shared<tape_value>(*this, at, count);
  out->on_tangents = on_tangents;
  return out;
}

tape_symbol tape_recorder::computed(const linear_form& form) {
  if (form.empty()) throw std::logic_error("a step uses a vector that it has given no value");
  if (form.size() == 1 && form[0].c == 1) {
    if (is_motion(form[0])) compute(*form[0].x);
    return form[0].x;
  }
  const auto motion = std::ranges::find_if(form.rbegin(), form.rend(), is_motion);
  if (motion == form.rend()) return combined(form);
  return combined_with_motion(form, static_cast<std::size_t>(form.rend() - motion) - 1);
}

tape_symbol tape_recorder::combined(const linear_form& form) {
  tape_instruction i{.op = tape_op::combine};
  for (const auto& t : form) {
    i.in[static_cast<std::size_t>(i.operands)] = t.x->at;
    i.constants[static_cast<std::size_t>(i.operands++)] = t.c;
  }
  const auto& first = *form[0].x;
  const auto out = fresh(first.rows, first.on_tangents);
  i.rows = first.rows;
  i.out = out->at;
  write(i);
  return out;
}

void tape_recorder::compute(tape_value& motion) {
  const auto at = computed(motion.point);
  const auto out = fresh(at->rows, at->on_tangents);
  write({.op = tape_op::motion, .on_tangents = motion.on_tangents, .operands = 1, .out = out->at, .in = {at->at}});
  motion.at = std::exchange(out->at, tape_value::not_computed);
  motion.point.clear();
}

/// sum c_i x_i with x_which = motion(mu + c x): one pass where the other terms are multiples of mu and x.
tape_symbol tape_recorder::combined_with_motion(linear_form form, std::size_t which) {
  for (std::size_t i = 0; i < form.size(); ++i)
    if (i != which && is_motion(form[i])) compute(*form[i].x);
  const auto motion = form[which].x;
  point at;
  bool one_pass =
      components_ <= most_components_of_a_stage && motion->rows == components_ && is_point(motion->point, at);
  std::array<double, tape_instruction::most_operands> c{0, 0, form[which].c, at.c};
  for (std::size_t i = 0; i < form.size() && one_pass; ++i) {
    if (i == which) continue;
    if (form[i].x == at.mu) {
      c[0] += form[i].c;
    } else if (!at.x || form[i].x == at.x) {
      at.x = form[i].x;
      c[1] += form[i].c;
    } else {
      one_pass = false;
    }
  }
  if (!one_pass) {
    compute(*motion);
    return combined(form);
  }
  if (!at.x) at.x = at.mu;
  const auto out = fresh(motion->rows, motion->on_tangents);
  write({.op = tape_op::stage,
         .on_tangents = motion->on_tangents,
         .operands = 2,
         .out = out->at,
         .in = {at.mu->at, at.x->at},
         .constants = c});
  return out;
}

void tape_recorder::assign(int to, int from, double constant) {
  write({.op = tape_op::copy, .operands = 1, .out = to, .in = {from}, .constants = {constant}});
}

void tape_recorder::finish(const linear_form& form) {
  const auto last = computed(form);
  // What the last operation computes goes to where the state was: no face reads there what it has yet to write.
  if (last->at != 0 && code_.size() > piece_start_ && code_.back().out == last->at && writes_state(code_.back().op))
    code_.back().out = 0;
  else if (last->at != 0)
    write({.op = tape_op::combine, .operands = 1, .rows = rows(), .out = 0, .in = {last->at}, .constants = {1}});
  ended_ = true;
}

bool tape_recorder::any(int question) {
  if (asked_ == answers_.size()) {
    question_ = question;
    throw unanswered{};
  }
  piece_start_ = code_.size();
  return answers_[asked_++];
}

std::unique_ptr<tape_piece> tape_recorder::last_piece() const {
  auto out = std::make_unique<tape_piece>();
  out->code.assign(code_.begin() + static_cast<std::ptrdiff_t>(piece_start_), code_.end());
  out->ends = ended_;
  out->question = question_;
  out->rows = all_rows_;
  return out;
}

tape::tape(int components, int tangents, bool joins, recorded_step step)
    : components_(components), tangents_(tangents), joins_(joins), step_(std::move(step)) {}

std::unique_ptr<tape_piece> tape::record(const std::vector<bool>& answers) const {
  tape_recorder recorder(components_, tangents_, answers);
  try {
    step_(recorder);
  } catch (const tape_recorder::unanswered&) {  // the piece ends there
  }
  auto piece = recorder.last_piece();
  if (joins_ && answers.empty() && piece->ends) piece->code = joined(piece->code, rows());
  return piece;
}

const tape_piece& tape::after(const tape_piece& piece, const std::vector<bool>& answers, bool answer) const {
  auto& next = piece.next[answer];
  if (const auto* known = next.load(std::memory_order_acquire)) return *known;
  const std::lock_guard lock(recording_);
  if (const auto* known = next.load(std::memory_order_acquire)) return *known;
  auto all = answers;
  if (&piece != &before_) all.push_back(answer);
  pieces_.push_back(record(all));
  next.store(pieces_.back().get(), std::memory_order_release);
  return *pieces_.back();
}

}  // namespace polhode
