// SPDX-License-Identifier: Apache-2.0
// What a step writes when it runs on symbols: one operation for each thing that it asks of its system, one pass for
// what can be done in one, and questions whose answers are recorded when they are given.
#include <gtest/gtest.h>

#include <algorithm>

#include "ensemble/tapes/tape_joins.hpp"
#include "ensemble/tapes/taped.hpp"
#include "systems/scheme_table.hpp"

namespace polhode::test {
namespace {

using system_symbol = taped_system<taped_traits{}>;
using vector = system_symbol::vector;
using increment = wiener_levy<taped, -1>;

constexpr int components = 3;
constexpr double dt = 0.1;

/// The operations of a step that asks nothing.
template <class Step>
std::vector<tape_instruction> written(Step step) {
  const tape t(components, 0, false, [&](tape_recorder& recorder) {
    increment w;
    w.dt = dt;
    w.area = {&recorder};
    recorder.finish(step(system_symbol{}, vector(recorder.start()), w).form());
  });
  EXPECT_TRUE(t.start().ends);
  return t.start().code;
}
std::vector<tape_op> operations(const std::vector<tape_instruction>& code) {
  std::vector<tape_op> out;
  for (const auto& i : code) out.push_back(i.op);
  return out;
}
template <class Step>
std::vector<tape_op> operations_of(Step step) {
  return operations(written(step));
}

const scheme_row& row_of(std::string_view name) {
  return *std::ranges::find(scheme_table(), name, [](const auto& row) { return row.info.name; });
}
std::vector<tape_op> operations_of(const tape& t) { return operations(t.start().code); }

TEST(Tape, OfHeunIsAMotionAndAStage) {
  const auto tapes = row_of("heun").tapes({}, components, 0, dt).noisy;
  EXPECT_EQ(operations_of(*tapes.opening), (std::vector{tape_op::motion, tape_op::stage}));
  EXPECT_EQ(tapes.opening, tapes.following);
  EXPECT_EQ(tapes.closing, nullptr);
}

TEST(Tape, OfLieHeunIsTwoGeneratorsTwoActionsAndASum) {
  EXPECT_EQ(operations_of(*row_of("lie_heun").tapes({}, components, 0, dt).noisy.opening),
            (std::vector{tape_op::generator, tape_op::exp_action, tape_op::generator, tape_op::combine,
                         tape_op::exp_action}));
}

TEST(Tape, JoinsTwoOperationsWhereNothingElseReadsWhatIsBetween) {
  const auto joined = [](std::string_view scheme) {
    return operations_of(*row_of(scheme).tapes({.joins = true}, components, 0, dt).noisy.following);
  };
  EXPECT_EQ(joined("lie_euler"), std::vector{tape_op::exp_of_generator});
  EXPECT_EQ(joined("lie_milstein"), std::vector{tape_op::exp_of_generator});
  EXPECT_EQ(joined("lie_heun"), (std::vector{tape_op::generator, tape_op::generator_of_turned, tape_op::exp_of_sum}));
  EXPECT_EQ(joined("magnus"), (std::vector{tape_op::generator, tape_op::generator_of_turned, tape_op::exp_of_sum}));
  EXPECT_EQ(joined("strang_two_turns"), std::vector{tape_op::noise_after_first_turn});
}

TEST(Tape, DoesNotJoinWhatIsReadOnceMore) {
  const auto of = [](auto step) {
    const tape t(components, 0, true, [&](tape_recorder& recorder) {
      increment w;
      w.dt = dt;
      recorder.finish(step(system_symbol{}, vector(recorder.start()), w).form());
    });
    return operations_of(t);
  };
  using g = system_symbol::algebra;
  EXPECT_EQ(of([](const auto& s, const auto& mu, const auto& w) {
              const auto xi = generator(s, mu, w);
              return g::exp_action(xi, mu) + xi;
            }),
            (std::vector{tape_op::generator, tape_op::exp_action, tape_op::combine}));
  EXPECT_EQ(of([](const auto& s, const auto& mu, const auto& w) {
              const auto turned = g::exp_action(generator(s, mu, w), mu);
              return generator(s, turned, w) + turned;
            }),
            (std::vector{tape_op::exp_of_generator, tape_op::generator, tape_op::combine}));
  EXPECT_EQ(of([](const auto& s, const auto& mu, const auto& w) {
              const auto ahead = generator(s, mu, w);
              const auto second = generator(s, g::exp_action(ahead, mu), w), turned = g::exp_action(ahead, mu);
              return g::exp_action(second, turned);
            }),
            (std::vector{tape_op::generator, tape_op::generator_of_turned, tape_op::exp_action, tape_op::exp_action}));
}

// Registers are used again: an exponential before the area reads another number from the same place.
TEST(Tape, JoinsAnAreaWithWhatReadsItAlone) {
  constexpr int rows = components, x = 10, y = 20;
  const tape_instruction area{.op = tape_op::area_noise, .out = x},
      exp{.op = tape_op::exp_of_sum, .operands = 3, .out = 0, .in = {y, x, 0}, .constants = {1, 1}},
      of_state{.op = tape_op::area_noise, .operands = 1, .out = x, .in = {0}};
  auto sum = exp;
  sum.constants = {1, 0.5};
  const auto after = joined({exp, area, exp}, rows);
  ASSERT_EQ(after.size(), 2u);
  EXPECT_FALSE(after[0].with_area);
  EXPECT_TRUE(after[1].with_area);
  EXPECT_EQ(after[1].operands, 2);
  EXPECT_EQ(after[1].in[0], y);
  EXPECT_EQ(after[1].in[1], 0);
  EXPECT_EQ(joined({exp, area}, rows).size(), 2u) << "read by nothing after it";
  EXPECT_EQ(joined({area, exp, exp}, rows).size(), 3u) << "read twice";
  EXPECT_EQ(joined({area, sum}, rows).size(), 2u) << "half of it";
  EXPECT_EQ(joined({of_state, exp}, rows).size(), 2u) << "of the state";
}

TEST(Tape, LastOperationWritesTheState) {
  for (const auto& row : scheme_table()) {
    const auto t = row.tapes({}, components, 0, dt).noisy.opening;
    if (!t->start().ends) continue;
    EXPECT_EQ(t->start().code.back().out, 0) << row.info.name;
  }
}

// A splitting merges its last flow with the first of the next step where the system's is exact.
TEST(Tape, SplittingMergesExactFlowsAlone) {
  const taped_traits exact{}, approximate{.exact_dissipation = false};
  EXPECT_NE(row_of("strang").tapes(exact, components, 0, dt).noisy.closing, nullptr);
  EXPECT_NE(row_of("strang").tapes(approximate, components, 0, dt).noisy.closing, nullptr);
  EXPECT_NE(row_of("strang_weak2").tapes(exact, components, 0, dt).noisy.closing, nullptr);
  EXPECT_EQ(row_of("strang_weak2").tapes(approximate, components, 0, dt).noisy.closing, nullptr);
}

// Where there are always three components or six it inverts a matrix; else it repeats its equation first.
TEST(Tape, MidpointAsksForTheNumberOfComponents) {
  const auto has = [](const step_tapes& t, tape_op op) {
    return std::ranges::count(operations_of(*t.opening), op) > 0;
  };
  for (const auto name : {"implicit_midpoint", "isospectral_midpoint"}) {
    const auto& row = row_of(name);
    for (const int n : {3, 6})
      EXPECT_TRUE(has(row.tapes({.components = n}, n, 0, dt).noisy, tape_op::inverse_derivative)) << name << n;
    for (const int n : {3, 5, 6, 24})
      EXPECT_FALSE(has(row.tapes({}, n, 0, dt).noisy, tape_op::inverse_derivative)) << name;
    EXPECT_FALSE(has(row.tapes({.components = 3}, 3, 2, dt).noisy, tape_op::inverse_derivative))
        << name << ", tangents";
  }
}

// Newton's method takes a correction more where there is noise.
TEST(Tape, MidpointAsksWhetherThereIsNoise) {
  const auto tapes = row_of("implicit_midpoint").tapes({.components = components}, components, 0, dt);
  const auto corrections = [](const tape& t) { return std::ranges::count(operations_of(t), tape_op::correct); };
  EXPECT_EQ(corrections(*tapes.silent.opening), 2);
  EXPECT_EQ(corrections(*tapes.noisy.opening), 3);
}

TEST(Tape, WithoutNoiseNothingIsAskedOfIt) {
  for (const auto& row : scheme_table()) {
    const auto silent = row.tapes({}, components, 0, dt).silent;
    for (const auto op : operations_of(*silent.opening)) {
      EXPECT_NE(op, tape_op::noise) << row.info.name;
      EXPECT_NE(op, tape_op::area_noise) << row.info.name;
      EXPECT_NE(op, tape_op::noise_twice) << row.info.name;
      EXPECT_NE(op, tape_op::noise_flow) << row.info.name;
      EXPECT_NE(op, tape_op::ito_drift) << row.info.name;
    }
  }
}

TEST(Tape, NoiseThatDependsOnTheStateIsAnotherStep) {
  const taped_traits varying{.noise = taped_noise::varying}, unbracketed{.noise = taped_noise::unbracketed};
  const auto slopes = [&](const taped_traits& t) {
    return std::ranges::count(operations_of(*row_of("lie_milstein").tapes(t, components, 0, dt).noisy.opening),
                              tape_op::noise_slope);
  };
  EXPECT_EQ(slopes({}), 0);
  EXPECT_EQ(slopes(varying), 1);
  EXPECT_EQ(row_of("lie_milstein").inapplicable(varying), "");
  EXPECT_NE(row_of("lie_milstein").inapplicable(unbracketed), "");
  EXPECT_NE(row_of("lie_euler").inapplicable(varying), "");
  EXPECT_EQ(row_of("heun").inapplicable(unbracketed), "");
}

TEST(Tape, SystemThatLacksWhatASchemeNeedsIsNamed) {
  EXPECT_EQ(row_of("strang").inapplicable({.turns = false}), "the system does not split into flows");
  EXPECT_EQ(row_of("strang_weak2").inapplicable({.turns = false}), "");
  EXPECT_EQ(row_of("strang_weak2").inapplicable({.flows = false, .turns = false}),
            "the system does not split into flows");
  EXPECT_NE(row_of("isospectral_midpoint").inapplicable({.matrices = false}).find("needs an algebra of matrices"),
            std::string::npos);
  EXPECT_EQ(row_of("implicit_midpoint").inapplicable({.matrices = false}), "");
}

TEST(Tape, NoiseOfWeakOrderTwoIsAskedForByTwoSchemes) {
  for (const auto& row : scheme_table()) {
    const bool prepares = row.info.name == "strang_weak2" || row.info.name == "strang_two_turns";
    EXPECT_EQ(row.weak_order_two_at(dt), prepares ? dt : 0) << row.info.name;
  }
}

TEST(Tape, MotionThatHasANameIsComputedOnce) {
  EXPECT_EQ(operations_of([](const auto& s, const auto& mu, const auto& w) {
              const auto first = motion(s, mu, w);
              const auto sum = first + first;
              return sum + taped(2.0) * first;
            }),
            (std::vector{tape_op::motion, tape_op::combine, tape_op::combine}));
}

TEST(Tape, StageIsOnePassForFewComponentsAlone) {
  const auto step = [](tape_recorder& recorder) {
    const increment w;
    const vector mu(recorder.start());
    recorder.finish((mu + taped(0.5) * motion(system_symbol{}, mu, w)).form());
  };
  EXPECT_EQ(operations_of(tape(6, 0, false, step)), (std::vector{tape_op::stage}));
  EXPECT_EQ(operations_of(tape(7, 0, false, step)), (std::vector{tape_op::motion, tape_op::combine}));
  EXPECT_EQ(operations_of(tape(3, 2, false, step)), (std::vector{tape_op::motion, tape_op::combine}))
      << "with tangents";
}

TEST(Tape, SumOfManyTermsIsSeveral) {
  const auto code = written([](const auto&, const auto& mu, const auto&) {
    vector sum = taped(2.0) * mu;
    for (int i = 0; i < 9; ++i) sum = sum + taped(1.0 + i) * mu;
    return sum;
  });
  for (const auto& i : code) EXPECT_LE(i.operands, tape_instruction::most_operands);
}

// Copies share a register until one is assigned to.
TEST(Tape, AssignedComponentLeavesCopiesAlone) {
  const auto code = written([](const auto&, const auto& mu, const auto&) {
    vector m = mu;
    m[1] = taped(7.0);
    return m - mu;
  });
  ASSERT_EQ(operations(code), (std::vector{tape_op::combine, tape_op::copy, tape_op::combine}));
  EXPECT_NE(code[0].out, 0);
  EXPECT_EQ(code[1].out, code[0].out + 1);
  EXPECT_EQ(code[2].in[0], code[0].out);
  EXPECT_EQ(code[2].in[1], 0);
}

TEST(Tape, AnswersAreRecordedWhenTheyAreGiven) {
  int runs = 0;
  const tape t(components, 0, false, [&](tape_recorder& recorder) {
    ++runs;
    const vector mu(recorder.start());
    const auto large = dot(mu, mu) > taped(1.0);
    recorder.finish((any(taped(0.0), large) ? taped(0.5) * mu : taped(2.0) * mu).form());
  });
  EXPECT_EQ(runs, 0);
  const auto& start = t.start();
  EXPECT_EQ(runs, 1);
  EXPECT_FALSE(start.ends);
  EXPECT_EQ(operations(start.code), (std::vector{tape_op::dot, tape_op::less}));
  EXPECT_EQ(start.question, start.code.back().out);
  const auto& yes = t.after(start, {}, true);
  const auto& no = t.after(start, {}, false);
  EXPECT_EQ(runs, 3);
  EXPECT_EQ(&t.after(start, {}, true), &yes) << "met before";
  EXPECT_EQ(runs, 3);
  EXPECT_TRUE(yes.ends && no.ends);
  EXPECT_EQ(yes.code.back().constants[0], 0.5);
  EXPECT_EQ(no.code.back().constants[0], 2);
}

TEST(Tape, VectorWithoutAValueIsAFault) {
  EXPECT_THROW(written([](const auto&, const auto&, const auto&) { return vector{}; }), std::logic_error);
}

}  // namespace
}  // namespace polhode::test
