// SPDX-License-Identifier: Apache-2.0
// The mean energy without dissipation: known answers, the bound for all times, and defects.
#include <gtest/gtest.h>

#include <cmath>

#include "experiments/energy/energy_trace.hpp"
#include "run/run_experiment.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "sphere/closed_forms/energy_drift.hpp"
#include "support/verdicts.hpp"
#include "systems/bind.hpp"
#include "systems/rigid_body/rigid_body.hpp"
#include "transfer/transfer.hpp"

namespace polhode {
namespace {

using report::verdict_kind;

report::scene scene_of(const std::vector<double>& inertia, double noise = 1) {
  auto scene = load_scene("paper");
  scene.vector("inertia") = inertia;
  for (auto& v : scene.vectors("sigma"))
    for (double& x : v) x *= noise;
  return scene;
}

report::results trace_of(const subject& s) { return test::quick_report(s, report_energy_trace); }

/// E over a rotation by sigma sqrt(dt) g of harmonics of degree two, s = sigma^2 dt.
double degree_two_factor(double s) {
  return (1 + 2 * (1 - s) * std::exp(-s / 2) + 2 * (1 - 4 * s) * std::exp(-2 * s)) / 5;
}

TEST(EnergyDrift, HarmonicsAgreeWithTheClosedForm) {
  const auto isotropic = body_on_sphere({1, 2, 3}, 0, 1.5, 0.25 * Eigen::Matrix3d::Identity());
  auto nearly = isotropic;  // so that harmonics are taken
  nearly.covariance(0, 1) = nearly.covariance(1, 0) = 1e-9;
  const points_on_sphere points = 1.5 * sphere_quadrature(4).points;
  for (const double time : {0.01, 0.1, 0.4}) {
    const auto closed = energy_without_dissipation(isotropic, points, time),
               found = energy_without_dissipation(nearly, points, time);
    EXPECT_LT((closed.value - found.value).cwiseAbs().maxCoeff(), 2e-9 * time + found.uncertainty + 1e-14) << time;
    EXPECT_LT(found.uncertainty, 1e-9);
  }
  const auto soon = energy_without_dissipation(isotropic, points, 1e-6),
             now = energy_without_dissipation(isotropic, points, 0);
  EXPECT_LT(((soon.value - now.value) / 1e-6 - energy_drift(isotropic, points)).cwiseAbs().maxCoeff(), 1e-6);
}

// A turn about the figure axis keeps the energy of a body of revolution, so that of Strang's step the noise alone is
// left: E[h] = m + (h - m) factor^n.
TEST(EnergyTrace, OfABodyOfRevolutionIsKnown) {
  const auto scene = scene_of({2, 2, 1});
  const auto r = trace_of(restricted(bind_scene(scene), {"strang"}));
  const double energy = (0.36 + 0.4800 * 0.48) / 4 + 0.64 * 0.64 / 2, mean = (0.5 + 0.5 + 1) / 6;
  int compared = 0;
  for (const auto& m : r.measurements) {
    if (m.quantity != "drift of E[h]" || m.observable != "at the start" || !m.dt()) continue;
    const double s = 0.25 * *m.dt();
    EXPECT_NEAR(*m.value, std::fabs((degree_two_factor(s) - std::exp(-3 * s)) * (energy - mean) / *m.dt()), 1e-8)
        << *m.dt();
    ++compared;
  }
  EXPECT_GE(compared, 5);
}

/// Strang's with a noise so scaled that harmonics of degree two relax as they should.
struct keeps_the_trace {
  static constexpr auto info = [] {
    auto out = strang::info;
    out.name = "keeps_the_trace";
    out.weak_order = {.one_vector = 2, .isotropic = 2, .general = 2};
    return out;
  }();
  static double share(double s) {
    thread_local double known = 0, found = 1;
    if (s == known) return found;
    double least = 0, most = 2 * s;  // factor falls there
    for (int i = 0; i < 100; ++i)
      (degree_two_factor((least + most) / 2) > std::exp(-3 * s) ? least : most) = (least + most) / 2;
    known = s;
    return found = std::sqrt(least / s);
  }
  template <class System, class S>
  static auto step(const System& system, const vec<S, System::dimension>& mu, const wiener<S, System::channels>& w) {
    auto scaled = w;
    for (int i = 0; i < 3; ++i) scaled.dw[i] = scaled.dw[i] * S(share(0.25 * w.dt));
    return strang::step(system, mu, scaled);
  }
};

TEST(EnergyTrace, IsExactAtEveryDtForOneThatPreservesIt) {
  const auto r = trace_of(bind(scene_of({2, 2, 1}), make_rigid_body, scheme_list<keeps_the_trace>{}));
  ASSERT_EQ(r.verdicts.size(), 1u);
  EXPECT_EQ(r.verdicts[0].kind, verdict_kind::holds);
  int rows = 0;
  for (const auto& m : r.measurements)
    if (m.observable == "largest on the sphere" && m.dt()) {
      EXPECT_LT(*m.value, 1e-9) << *m.dt();
      ++rows;
    }
  EXPECT_GE(rows, 5);
}

// Over forty relaxation times.
TEST(EnergyTrace, TheErrorAtAnyTimeIsBounded) {
  auto scene = load_scene("paper");
  const auto s = restricted(bind_scene(scene), {"lie_heun"});
  const auto r = trace_of(s);
  scene.number("theta") = 0;
  const auto free = restricted(bind_scene(scene), {"lie_heun"});
  const auto problem = *free.sphere();
  const Eigen::Vector3d start(scene.momentum.data());
  const auto energy = *named_observable("energy", *s.sphere());
  int compared = 0;
  for (const auto& m : r.measurements) {
    if (m.quantity != "error of E[h] at any time, at most" || std::fabs(*m.dt() - 0.125) > 1e-9) continue;
    const auto op = make_transfer(free, free.schemes[0], *m.dt(), 1, {{12, 1, 0}, {7, 2}});
    double largest = 0;
    for (const int steps : {1, 4, 16, 64, 427}) {
      const double mean = op.law_after(start, steps).dot(op.basis.coefficients(energy));
      largest = std::max(largest, std::fabs(mean - relaxed_energy(problem, energy(start), steps * *m.dt())));
    }
    EXPECT_LE(largest, *m.value);
    EXPECT_GT(largest, 0.01 * *m.value);
    ++compared;
  }
  EXPECT_EQ(compared, 1);
}

TEST(EnergyTrace, DefectsAndOverclaimsAreRefuted) {
  const std::vector<std::string> schemes{"heun", "lie_euler", "strang", "strang_weak2"};
  auto s = restricted(bind_scene(load_scene("paper")), schemes);
  const auto healthy = trace_of(s);
  ASSERT_EQ(healthy.verdicts.size(), 4u);
  for (const auto& v : healthy.verdicts) EXPECT_EQ(v.kind, verdict_kind::holds) << v.scheme << ": " << v.reason;

  auto spoilt = s;  // noise a thousandth too strong
  spoilt.with = [&](const report::scene& other) {
    auto out = restricted(bind_scene(other), schemes);
    auto louder = other;
    for (auto& v : louder.vectors("sigma"))
      for (double& x : v) x *= 1.001;
    out.schemes = restricted(bind_scene(louder), schemes).schemes;
    return out;
  };
  const auto of_spoilt = trace_of(spoilt);
  ASSERT_EQ(of_spoilt.verdicts.size(), 4u);
  for (const auto& v : of_spoilt.verdicts) EXPECT_EQ(v.kind, verdict_kind::refuted) << v.scheme << v.reason;

  auto over = s;
  over.with = [&](const report::scene& other) {
    auto out = restricted(bind_scene(other), {"strang"});
    out.schemes[0].info.weak_order = {.one_vector = 2, .isotropic = 2, .general = 2};
    return out;
  };
  const auto of_over = trace_of(over);
  ASSERT_EQ(of_over.verdicts.size(), 1u);
  EXPECT_EQ(of_over.verdicts[0].kind, verdict_kind::refuted) << of_over.verdicts[0].reason;
}

}  // namespace
}  // namespace polhode
