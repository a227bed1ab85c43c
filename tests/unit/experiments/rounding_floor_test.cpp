// SPDX-License-Identifier: Apache-2.0
// The floor of rounding: its unit in closed form, and what is kept in single precision beside healthy schemes.
#include "experiments/common/rounding_floor.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <polhode/noise/normal.hpp>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/levels.hpp"
#include "problem/vectors.hpp"
#include "run/bind_scene.hpp"
#include "scene/scene.hpp"
#include "support/kernel_decorator.hpp"

namespace polhode {
namespace {

subject silent(const char* name) { return bind_scene(load_scene(name)).without_noise(); }

double condition_of(const model& m, std::initializer_list<double> mu) {
  return energy_condition(m, replicated({mu.begin(), mu.size()}));
}

void round_to_float(std::span<double> numbers) {
  for (double& x : numbers) x = static_cast<float>(x);
}

/// States in single precision.
struct float_kernel : test::kernel_decorator {
  using kernel_decorator::advance, kernel_decorator::kernel_decorator;
  void advance(std::span<double> states, const increment_view& noise, piece p) const override {
    kernel_decorator::advance(states, noise, p);
    round_to_float(states);
  }
};

/// Energies of blocks in single precision; of a model only what the floor asks for.
struct float_energy : model {
  explicit float_energy(std::shared_ptr<const model> of) : inner(std::move(of)) {}
  int dimension() const override { return inner->dimension(); }
  noise_layout layout() const override { return inner->layout(); }
  noise_class noise() const override { return inner->noise(); }
  double energy(std::span<const double> mu) const override { return inner->energy(mu); }
  double dissipation_rate(std::span<const double> mu) const override { return inner->dissipation_rate(mu); }
  std::vector<double> casimirs(std::span<const double> mu) const override { return inner->casimirs(mu); }
  std::vector<double> casimir_sizes(std::span<const double> mu) const override { return inner->casimir_sizes(mu); }
  void conserved(std::span<const double> states, std::span<double> energies,
                 std::span<double> casimirs) const override {
    inner->conserved(states, energies, casimirs);
    round_to_float(energies);
  }
  void drift(std::span<const double> mu, std::span<double> out) const override { inner->drift(mu, out); }
  void drifts(std::span<const double> states, std::span<double> out) const override { inner->drifts(states, out); }
  void coadjoint(std::span<const double> xi, std::span<const double> mu, std::span<double> out) const override {
    inner->coadjoint(xi, mu, out);
  }
  void coarsen(const increment_view& fine, int factor, std::span<double> dw, std::span<double> area) const override {
    inner->coarsen(fine, factor, dw, area);
  }
  std::unique_ptr<kernel> reference(double dt) const override { return inner->reference(dt); }

  std::shared_ptr<const model> inner;
};

// h = sum Pi_k^2 / 2 I_k, I = (1, 2, 3): |Omega| |Pi| / sqrt 3.
TEST(RoundingFloor, ConditionOfABodyIsItsTurningRate) {
  const auto paper = silent("paper");
  const double rate = std::hypot(0.6, 0.48 / 2, 0.64 / 3);
  EXPECT_NEAR(condition_of(*paper.model, {0.6, 0.48, 0.64}), rate / std::sqrt(3.0), 1e-9);
}

// About an axis it does not move, so that the mean over the way is what it is at the start.
TEST(RoundingFloor, ConditionOnTheWayIsItsMeanOverTheSteps) {
  const auto paper = silent("paper");
  for (const auto& scheme : paper.schemes) {
    const double found =
        condition_on_the_way(*paper.model, *scheme.make(0.1), replicated(std::vector{0.0, 0.0, 1.0}), silence(7));
    EXPECT_NEAR(found, 1 / 3.0 / std::sqrt(3.0), 1e-9) << scheme.info.name;
  }
}

// Of two, h = -(Gamma_1 Gamma_2 / 4 pi) log g, |dh/dmu_1| = |Gamma_2| / 4 pi sqrt(2 / g), and so of the other: grows
// without bound where they meet, as h does not.
TEST(RoundingFloor, ConditionOfTwoVorticesGrowsWhereTheyMeet) {
  const auto scene = load_scene("vortex_pair");
  const auto pair = bind_scene(scene).without_noise();
  const auto& strengths = scene.vector("strengths");
  const double squares = std::pow(strengths[0], 2) + std::pow(strengths[1], 2);
  for (const double angle : {2.0, 0.1, 0.01}) {
    const double g = 2 * std::pow(std::sin(angle / 2), 2);
    EXPECT_NEAR(condition_of(*pair.model, {0, 0, -strengths[0], -strengths[1] * std::sin(angle), 0,
                                           -strengths[1] * std::cos(angle)}) /
                    (squares / (4 * std::numbers::pi) * std::sqrt(2 / g) / std::sqrt(6.0)),
                1, 1e-5)
        << angle;
  }
}

class RoundingFloorOf : public testing::TestWithParam<const char*> {};

TEST_P(RoundingFloorOf, ToldFromSinglePrecision) {
  auto s = silent(GetParam());
  const context c{.subject = s};
  for (const auto& healthy : s.schemes) {
    const auto found = rounding_floor_of(c, s, healthy);
    EXPECT_LE(found.state, floor_bound) << healthy.info.name;
    EXPECT_LE(found.energy, floor_bound) << healthy.info.name;
    auto rounded = healthy;
    rounded.make = [&](double dt) { return std::make_unique<float_kernel>(healthy.make(dt)); };
    const auto single = rounding_floor_of(c, s, rounded);
    EXPECT_GT(single.state, 1e4 * floor_bound) << healthy.info.name;
    EXPECT_GT(single.energy, 1e4 * floor_bound) << healthy.info.name;
  }
  const auto kept = s.model;
  s.model = std::make_shared<float_energy>(kept);
  EXPECT_GT(rounding_floor_of(c, s, s.schemes.front()).energy, 1e4 * floor_bound);
}

INSTANTIATE_TEST_SUITE_P(Scenes, RoundingFloorOf, testing::Values("paper", "vortices"),
                         [](const auto& scene) { return std::string(scene.param); });

/// Adds independent normal numbers of one size to every state.
struct noisy_kernel : test::kernel_decorator {
  using kernel_decorator::advance;
  noisy_kernel(std::unique_ptr<kernel> of, double size, std::uint64_t& calls)
      : kernel_decorator(std::move(of)), size_(size), calls_(calls) {}
  void advance(std::span<double> states, const increment_view& noise, piece p) const override {
    kernel_decorator::advance(states, noise, p);
    ++calls_;
    for (std::size_t i = 0; i < states.size(); ++i)
      states[i] += size_ * normals<1>({calls_, noise_kind::increment, i, 0})[0];
  }
  double size_;
  std::uint64_t& calls_;
};

// Of three components, over 2^-52 sqrt(16) and |mu|; of the energy |Omega| times as much, over what energies of blocks
// are known to.
TEST(RoundingFloor, IsTheSizeOfWhatScatters) {
  auto s = silent("paper");
  const context c{.subject = s};
  auto noisy = s.schemes.front();
  std::uint64_t calls = 0;
  const double size = 1e-9, unit = 0x1p-52 * 4;
  noisy.make = [&, healthy = noisy.make](double dt) {
    return std::make_unique<noisy_kernel>(healthy(dt), size, calls);
  };
  const auto found = rounding_floor_of(c, s, noisy);
  const auto& mu = s.scene.momentum;
  const double turning = std::hypot(mu[0], mu[1] / 2, mu[2] / 3),
               condition = std::max(energy_size(s), turning / std::sqrt(3.0));
  EXPECT_NEAR(found.state / (std::sqrt(3.0) * size / (unit * length(mu))), 1, 0.2);
  EXPECT_NEAR(found.energy / (turning * size / (unit * condition)), 1, 0.25);
}

/// Moves states by what a test says.
struct made_kernel : test::kernel_decorator {
  using kernel_decorator::advance;
  using work = std::function<void(std::span<double>, const increment_view&)>;
  made_kernel(std::unique_ptr<kernel> of, work does) : kernel_decorator(std::move(of)), does_(std::move(does)) {}
  void advance(std::span<double> states, const increment_view& noise, piece) const override { does_(states, noise); }
  work does_;
};

// Each step doubles the state, so that the condition of a quadratic energy is four times as large.
TEST(RoundingFloor, ConditionOnTheWayIsThatOfTheStatesItPasses) {
  const auto paper = silent("paper");
  const made_kernel doubling(paper.schemes.front().make(0.1), [](std::span<double> states, const increment_view&) {
    for (double& x : states) x *= 2;
  });
  const auto start = replicated(std::vector{0.6, 0.48, 0.64});
  EXPECT_NEAR(condition_on_the_way(*paper.model, doubling, start, silence(3)) / energy_condition(*paper.model, start),
              std::sqrt((16 + 256 + 4096) / 3.0), 1e-8);
}

/// A body of another size than one whose fastest rate is known.
subject subject_of_rate(double rate) {
  auto scene = load_scene("paper");
  for (double& x : scene.momentum) x *= 1.7;
  auto s = bind_scene(scene);
  auto offers = *s.offers;
  offers.rates = {.motion = rate, .dissipation = 0, .noise = 0};
  s.offers = std::make_shared<const capabilities>(offers);
  return s;
}

// Sixteen steps of dt, of which one more changes the phase by 2^-10, or dt by almost that where nothing moves.
TEST(RoundingFloor, StepsDifferByAPartOfThePhase) {
  for (const double rate : {3.0, 1e-4}) {
    const auto s = subject_of_rate(rate);
    auto listening = s.schemes.front();
    std::vector<double> asked;
    listening.make = [&, healthy = listening.make](double dt) {
      asked.push_back(dt);
      return std::make_unique<made_kernel>(healthy(dt), [](std::span<double>, const increment_view&) {});
    };
    rounding_floor_of({.subject = s}, s, listening);
    const double dt = finest_step(s), phase = 16 * dt * rate;
    ASSERT_EQ(phase > 1e-3, rate > 1);
    const double apart = 0x1p-10 / (rate > 1 ? phase : 1e-3);
    ASSERT_EQ(asked.size(), 8u);
    for (std::size_t i = 0; i < 7; ++i) EXPECT_DOUBLE_EQ(asked[i], dt + static_cast<double>(i) * apart * dt);
    EXPECT_EQ(asked[7], dt);
  }
}

TEST(RoundingFloor, IsThatUnderTheNoiseOfTheFirstPaths) {
  const auto s = subject_of_rate(3);
  const context c{.subject = s, .seed = 8};
  auto listening = s.schemes.front();
  std::vector<double> heard;
  listening.make = [&, healthy = listening.make](double dt) {
    return std::make_unique<made_kernel>(healthy(dt), [&](std::span<double>, const increment_view& noise) {
      if (heard.empty()) heard.assign(noise.dw.begin(), noise.dw.end());
    });
  };
  rounding_floor_of(c, s, listening);
  increment_buffer buffer(*s.model, 16, listening.needs_areas, {c.generator, noise_quality::precise});
  const auto expected = buffer.fill(8, 0, 0, 16, finest_step(s)).dw;
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(heard, std::vector<double>(expected.begin(), expected.end()));
}

// One number of one lane is off at the fourth of seven steps: sixth difference 20, whose variance is 924 times its own.
TEST(RoundingFloor, OfOneNumberThatIsOff) {
  const auto s = subject_of_rate(3);
  const auto& mu = s.scene.momentum;
  const double off = 0x1p-10, each = 20 / std::sqrt(924.0) / std::sqrt(block_lanes), unit = 0x1p-52 * 4;
  for (const std::size_t component : {0, 2}) {
    auto moved = mu;
    moved[component] += off;
    auto scheme = s.schemes.front();
    int made = 0;
    scheme.make = [&, healthy = scheme.make](double dt) {
      const double by = ++made == 4 ? off : 0;
      return std::make_unique<made_kernel>(
          healthy(dt), [=](std::span<double> states, const increment_view&) { states[component * block_lanes] += by; });
    };
    const auto found = rounding_floor_of({.subject = s}, s, scheme);
    EXPECT_NEAR(found.state / (each * off / (unit * length(mu))), 1, 1e-10);
    const double energy = s.model->energy(moved) - s.model->energy(mu),
                 size = std::max(energy_size(s), energy_condition(*s.model, replicated(mu)));
    EXPECT_NEAR(found.energy / (each * energy / (unit * size)), 1, 1e-9);
  }
}

}  // namespace
}  // namespace polhode
