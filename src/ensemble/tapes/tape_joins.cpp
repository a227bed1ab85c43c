// SPDX-License-Identifier: Apache-2.0
#include "ensemble/tapes/tape_joins.hpp"

#include <algorithm>
#include <optional>
#include <span>

namespace polhode {
namespace {

using instructions = std::span<const tape_instruction>;

/// How often what stands in a register of a state is read, before it is written anew.
int times_read(instructions code, int at, int rows) {
  int times = 0;
  for (const auto& i : code) {
    times += static_cast<int>(std::count_if(i.in.begin(), i.in.begin() + i.operands,
                                            [&](int from) { return from >= at && from < at + rows; }));
    if (i.out == at && writes_state(i.op)) return times;
  }
  return at == 0 ? times + 1 : times;  // the state after the step
}

/// The second of two operations with the first one in it, where there is such an operation.
std::optional<tape_instruction> both(const tape_instruction& first, const tape_instruction& second) {
  if (second.in[0] != first.out || first.on_tangents || second.on_tangents) return std::nullopt;
  auto out = first;
  out.out = second.out;
  const bool turns = second.op == tape_op::exp_action;
  if (first.op == tape_op::generator && turns && second.in[1] == first.in[0]) {
    out.op = tape_op::exp_of_generator;
  } else if (first.op == tape_op::exp_action && second.op == tape_op::generator) {
    out.op = tape_op::generator_of_turned;
  } else if (first.op == tape_op::combine && first.operands <= most_terms_of_exp && turns) {
    out.op = tape_op::exp_of_sum;
    out.in[static_cast<std::size_t>(out.operands++)] = second.in[1];
  } else if (first.op == tape_op::free_flow && second.op == tape_op::damped_noise_flow) {
    out.op = tape_op::noise_after_free_flow;
  } else if (first.op == tape_op::first_turn && second.op == tape_op::turned_noise_flow) {
    out.op = tape_op::noise_after_first_turn;
  } else {
    return std::nullopt;
  }
  return out;
}

/// Neighbours of which the second alone reads what the first gives.
void join_neighbours(std::vector<tape_instruction>& code, int rows) {
  for (std::size_t i = 0; i + 1 < code.size(); ++i)
    if (times_read(instructions(code).subspan(i + 1), code[i].out, rows) == 1)
      if (const auto one = both(code[i], code[i + 1])) {
        code[i] = *one;
        code.erase(code.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      }
}

/// The place of a register among the terms of an exponential, with the coefficient 1; none: what reads it is another.
std::optional<std::size_t> term_of(const tape_instruction& i, int at) {
  if (i.op != tape_op::exp_of_sum) return std::nullopt;
  for (std::size_t k = 0; k + 1 < static_cast<std::size_t>(i.operands); ++k)
    if (i.in[k] == at && i.constants[k] == 1) return k;
  return std::nullopt;
}

/// The area's term of an exponential is computed with it, where that alone reads the area, and the area no state.
void join_area(std::vector<tape_instruction>& code, int rows) {
  for (std::size_t i = 0; i < code.size(); ++i) {
    const int at = code[i].out;
    if (code[i].op != tape_op::area_noise || code[i].operands != 0) continue;
    if (times_read(instructions(code).subspan(i + 1), at, rows) != 1) continue;
    const auto reader =
        std::find_if(code.begin() + static_cast<std::ptrdiff_t>(i) + 1, code.end(), [&](const auto& later) {
          return std::find(later.in.begin(), later.in.begin() + later.operands, at) !=
                 later.in.begin() + later.operands;
        });
    const auto term = reader == code.end() ? std::nullopt : term_of(*reader, at);
    if (!term) continue;
    const auto k = static_cast<std::ptrdiff_t>(*term);
    std::copy(reader->in.begin() + k + 1, reader->in.begin() + reader->operands, reader->in.begin() + k);
    std::copy(reader->constants.begin() + k + 1, reader->constants.begin() + reader->operands,
              reader->constants.begin() + k);
    --reader->operands;
    reader->with_area = true;
    code.erase(code.begin() + static_cast<std::ptrdiff_t>(i));
    return;
  }
}

/// exp(generator(mu) + area) mu.
void join_generator(std::vector<tape_instruction>& code, int rows) {
  for (std::size_t i = 0; i + 1 < code.size(); ++i) {
    const auto &first = code[i], &second = code[i + 1];
    if (first.op == tape_op::generator && second.op == tape_op::exp_of_sum && second.operands == 2 &&
        second.constants[0] == 1 && second.in[0] == first.out && second.in[1] == first.in[0] &&
        times_read(instructions(code).subspan(i + 1), first.out, rows) == 1) {
      auto one = first;
      one.op = tape_op::exp_of_generator;
      one.out = second.out;
      one.with_area = second.with_area;
      code[i] = one;
      code.erase(code.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    }
  }
}

}  // namespace

std::vector<tape_instruction> joined(std::vector<tape_instruction> code, int rows) {
  join_neighbours(code, rows);
  join_area(code, rows);
  join_generator(code, rows);
  return code;
}

}  // namespace polhode
