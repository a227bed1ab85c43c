// SPDX-License-Identifier: Apache-2.0
// The search for a step size: errors that change sign, and hills between the steps that were looked at.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "selection/search.hpp"

namespace polhode {
namespace {

/// |dt^p (1 - dt / lucky)|: vanishes at `lucky`, and is at most p^p / (p + 1)^(p + 1) lucky^p below it.
class crossing_goal final : public goal {
 public:
  crossing_goal(double lucky, double order) : lucky_(lucky), order_(order) {}
  std::vector<candidate> candidates(const subject& s) const override {
    return {{std::string(s.schemes.front().info.name), s.schemes.front(), nullptr, order_}};
  }
  error_estimate error(const candidate&, double dt, std::uint64_t) const override {
    return {std::fabs(std::pow(dt, order_) * (1 - dt / lucky_)), 0};
  }
  double highest() const {
    return std::pow(order_, order_) / std::pow(order_ + 1, order_ + 1) * std::pow(lucky_, order_);
  }
  double floor() const override { return 1e-14; }
  double longest_step() const override { return 2; }
  std::string unit() const override { return "1"; }

 private:
  double lucky_, order_;
};

TEST(Select, AnErrorThatChangesSignIsMetBelowTheCrossingOrBeyondItsHighestPoint) {
  std::mt19937_64 random(11);
  const auto bound = bind_scene(load_scene("paper"));
  const context c{bound, effort::quick, 1, 1};
  for (int i = 0; i < 100; ++i) {
    const double order = 1 + i % 2, lucky = std::uniform_real_distribution(0.02, 1.0)(random);
    const crossing_goal g(lucky, order);
    const double tolerance = g.highest() * std::exp(std::uniform_real_distribution(-5.0, 0.5)(random));
    const goal_question q{"weak", "all", 2, tolerance};
    const search s(c, g, q);
    const auto who = g.candidates(bound).front();
    auto p = s.predict(who);
    std::string fault;
    const auto found = s.check(p, fault);
    ASSERT_TRUE(found) << fault;
    double worst = 0;
    for (double dt = found->dt; dt > found->dt / 10; dt /= 1.001) worst = std::max(worst, g.error(who, dt, 0).value);
    EXPECT_LE(worst, 1.01 * tolerance) << "crossing at " << lucky << ", order " << order << ", dt = " << found->dt;
  }
}

/// dt^1.2, so that of an order 1 the first step is too careful; and a hill so narrow that rungs may lie either side.
class hilly_goal final : public goal {
 public:
  hilly_goal(double top, double height) : top_(top), height_(height) {}
  std::vector<candidate> candidates(const subject& s) const override {
    return {{std::string(s.schemes.front().info.name), s.schemes.front(), nullptr, 1}};
  }
  error_estimate error(const candidate&, double dt, std::uint64_t) const override {
    seen_ = seen_ || hill(dt) > height_ / 2;
    return {std::pow(dt, 1.2) + hill(dt), 0};
  }
  /// Whether a step on the hill was looked at.
  bool seen() const { return seen_; }
  double floor() const override { return 1e-14; }
  double longest_step() const override { return 2; }
  std::string unit() const override { return "1"; }

 private:
  double hill(double dt) const { return height_ * std::exp(-std::pow(std::log(dt / top_) / 0.05, 2)); }

  double top_, height_;
  mutable bool seen_ = false;
};

/// A longer step is tried where the first is better than it need be. Where its rungs meet a hill that those of the
/// first missed, the first is no answer either.
TEST(Select, AHillSeenFromALongerStepCountsForTheShorterOneToo) {
  const auto bound = bind_scene(load_scene("paper"));
  const context c{bound, effort::quick, 1, 1};
  const double tolerance = 1e-4, longest = std::pow(tolerance, 1 / 1.2);
  int met = 0;
  for (double top = longest / 100; top < longest; top *= 1.01) {
    const hilly_goal g(top, 4 * tolerance);
    const goal_question q{"weak", "all", 2, tolerance};
    const search s(c, g, q);
    std::string fault;
    const auto found = s.check(s.predict(g.candidates(bound).front()), fault);
    ASSERT_TRUE(found) << fault;
    EXPECT_FALSE(g.seen() && top < found->dt && top > found->checked_to)
        << "a hill at " << top << ", dt = " << found->dt;
    met += g.seen() ? 1 : 0;
  }
  EXPECT_GE(met, 20) << "no hill was in the way: nothing is tested";
}

}  // namespace
}  // namespace polhode
