// SPDX-License-Identifier: Apache-2.0
// Scenes of every system: what is read, a system's own units, and each fault refused in one line.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "experiments/common/levels.hpp"
#include "run/reference.hpp"
#include "run/verify.hpp"
#include "scene_files.hpp"

namespace {

using polhode::bind_scene;
using polhode::load_scene;
using polhode::testing::scene_files;
using rows = polhode::report::number_rows;

struct system_scenes : scene_files {
  using keys = std::map<std::string, std::string>;
  static std::string text(const keys& given) {
    std::string out;
    for (const auto& [key, value] : given)
      if (!value.empty()) out += key + " = " + value + "\n";
    return out;
  }
  static keys spin() {
    return {{"system", "'spin'"}, {"quadratic", "[1, -2, 0.5]"},    {"theta", "0.5"}, {"sigma", "0.5"},
            {"horizon", "2.0"},   {"momentum", "[0.6, 0.48, 0.64]"}};
  }
  static keys own_units() {
    return {{"system", "'spin'"},
            {"anisotropy", "1.5"},
            {"damping", "0.2"},
            {"temperature", "0.4"},
            {"horizon", "2.0"},
            {"field", "[0, 0, 2]"},
            {"momentum", "[0.6, 0.48, 0.64]"}};
  }
  static keys so4() {
    return {{"system", "'so4_body'"},
            {"inertia", "[1, 2, 3, 4, 5, 6]"},
            {"coupling", "-0.3"},
            {"theta", "0.5"},
            {"sigma", "0.5"},
            {"horizon", "2.0"},
            {"momentum", "[1, 0, 0, 0, 2, 0]"}};
  }
  static keys top() {
    return {{"system", "'heavy_top'"}, {"inertia", "[1, 2, 3]"},
            {"weight", "1.5"},         {"axis", "[0, 0, 1]"},
            {"theta", "0.5"},          {"sigma", "0.5"},
            {"horizon", "2.0"},        {"momentum", "[0.3, -0.2, 0.5, 0, 0, 1]"}};
  }
  static keys ring() {
    return {{"system", "'spins'"},
            {"count", "3"},
            {"exchange", "0.5"},
            {"theta", "0.5"},
            {"sigma", "0.5"},
            {"horizon", "2.0"},
            {"momentum", "[0.6, 0.48, 0.64]"}};
  }
  /// At (0, 0, 1) and (0.6, 0, 0.8), of strengths 2 and -1.
  static keys two_vortices() {
    return {{"system", "'vortices'"}, {"strengths", "[2, -1]"}, {"theta", "0.5"},
            {"sigma", "0.5"},         {"horizon", "2.0"},       {"momentum", "[0, 0, -2, 0.6, 0, 0.8]"}};
  }
  static keys fluid() {
    return {{"system", "'sine_euler'"}, {"n", "3"},         {"theta", "0.5"},
            {"sigma", "0.5"},           {"horizon", "2.0"}, {"momentum", "[1, 2, 3, 4, 5, 6, 7, 8]"}};
  }
  void refuse(keys given, const std::string& key, const std::string& value,
              const std::vector<std::string>& said = {"accepted: "}) {
    SCOPED_TRACE(key + " = " + value);
    given[key] = value;
    expect_refused(write(text(given)), said);
  }
};

TEST_F(system_scenes, a_spin_may_give_its_matrix_as_a_diagonal_and_no_field) {
  const auto s = load_scene(write(text(spin())));
  EXPECT_EQ(s.vectors("quadratic"), (rows{{1, 0, 0}, {0, -2, 0}, {0, 0, 0.5}}));
  EXPECT_EQ(s.vector("field"), (std::vector<double>{0, 0, 0}));
}

// E = -K S_3^2 - B S_3 at damping alpha and temperature T: theta = alpha, sigma = sqrt(2 alpha T).
TEST_F(system_scenes, a_spin_in_its_own_units) {
  const auto s = load_scene(write(text(own_units())));
  EXPECT_EQ(s.vectors("quadratic"), (rows{{0, 0, 0}, {0, 0, 0}, {0, 0, -3}}));
  EXPECT_EQ(s.vector("field"), (std::vector<double>{0, 0, -2}));
  EXPECT_EQ(s.number("theta"), 0.2);
  ASSERT_EQ(s.vectors("sigma").size(), 3u);
  EXPECT_EQ(s.vectors("sigma")[0][0], std::sqrt(2 * 0.2 * 0.4));
  const auto cold = [&] {
    auto given = own_units();
    given["temperature"] = "0";
    return load_scene(write(text(given)));
  }();
  EXPECT_TRUE(cold.vectors("sigma").empty());
}

// The law is exp(-E/T): E[S_3] against an integral over S_3 alone.
TEST_F(system_scenes, a_spin_in_its_own_units_has_boltzmanns_law) {
  const auto s = load_scene(write(text(own_units())));
  double mean = 0, total = 0;
  const double c = std::sqrt(0.6 * 0.6 + 0.48 * 0.48 + 0.64 * 0.64);
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double z = c * (2 * (i + 0.5) / n - 1), weight = std::exp((1.5 * z * z + 2 * z) / 0.4);
    mean += weight * z;
    total += weight;
  }
  EXPECT_NEAR(polhode::reference(s, {"gibbs", "pi3", {}, 0}).value, mean / total, 1e-7);
}

// In a field along e_3, without dissipation, dS = -S x B dt: S_1' = -S_2 B, S_2' = S_1 B.
TEST_F(system_scenes, a_spin_in_its_own_units_precesses_as_landau_and_lifshitz_say) {
  auto given = own_units();
  given["anisotropy"] = "0.0";
  given["damping"] = "0.0";
  const auto s = load_scene(write(text(given)));
  std::vector<double> drift(3);
  bind_scene(s).model->drift(s.momentum, drift);
  EXPECT_DOUBLE_EQ(drift[0], -0.48 * 2);
  EXPECT_DOUBLE_EQ(drift[1], 0.6 * 2);
  EXPECT_EQ(drift[2], 0);
}

TEST_F(system_scenes, faults_of_a_spin_are_refused) {
  for (const auto* bad :
       {"[1, 2]", "1.0", "[[1, 2, 0], [3, 1, 0], [0, 0, 1]]", "[[1, 0], [0, 1]]", "[1, nan, 2]", "'x'", "[]"})
    refuse(spin(), "quadratic", bad, {"quadratic = ", "three finite numbers, or a symmetric 3 x 3 matrix"});
  for (const auto* bad : {"[1, inf, 2]", "[1, 2]", "1.0", "[[1, 2, 3]]"}) refuse(spin(), "field", bad, {"field = "});
  refuse(spin(), "theta", "-1.0", {"theta = -1.0", ">= 0"});
  refuse(spin(), "inertia", "[1, 2, 3]", {"inertia = ", "unknown key"});
  refuse(spin(), "momentum", "[1, 0, 0, 0, 0, 0]", {"momentum = ", "three finite numbers"});
  refuse(spin(), "quadratic", "", {"quadratic is missing"});
}

TEST_F(system_scenes, faults_of_a_spins_own_units_are_refused) {
  for (const auto* key : {"damping", "temperature"}) {
    refuse(own_units(), key, "-0.1", {std::string(key) + " = -0.1", ">= 0"});
    refuse(own_units(), key, "", {std::string(key) + " is missing"});
  }
  refuse(own_units(), "anisotropy", "[[1, 2], [2, 1]]", {"anisotropy = "});
  for (const auto* other : {"theta", "sigma"}) refuse(own_units(), other, "0.5", {"unknown key", "temperature"});
  refuse(own_units(), "quadratic", "[1, 2, 3]", {"quadratic = ", "unknown key"});
}

TEST_F(system_scenes, faults_of_coupled_bodies_are_refused) {
  for (const auto* bad : {"[1, 2, 3]", "[1, 2, 3, 4, 5, 0]", "[1, 2, 3, 4, 5, -6]", "1.0"})
    refuse(so4(), "inertia", bad, {"inertia = ", "six finite numbers > 0"});
  for (const auto* bad : {"[0.3]", "nan", "'x'"}) refuse(so4(), "coupling", bad, {"coupling = ", "a finite number"});
  refuse(so4(), "sigma", "[1, 2, 3]", {"sigma = ", "six of them"});
  refuse(so4(), "momentum", "[1, 2, 3]", {"momentum = ", "six finite numbers, not all zero"});
  refuse(so4(), "quadratic", "[1, 2, 3]", {"unknown key"});
}

TEST_F(system_scenes, faults_of_a_heavy_top_are_refused) {
  for (const auto* bad : {"[0.3, -0.2, 0.5, 0, 0, 1.1]", "[0.3, -0.2, 0.5, 0, 0, 0]", "[1, 2, 3]"})
    refuse(top(), "momentum", bad, {"momentum = ", "six finite numbers, the last three of length 1"});
  refuse(top(), "inertia", "[1, 2, -3]", {"inertia = ", "three finite numbers > 0"});
  refuse(top(), "axis", "[1, 2]", {"axis = ", "three finite numbers"});
  refuse(top(), "weight", "inf", {"weight = ", "a finite number"});
  refuse(top(), "coupling", "0.1", {"coupling = ", "unknown key"});
}

TEST_F(system_scenes, spins_on_a_ring_a_chain_or_bound_as_given) {
  auto given = ring();
  EXPECT_EQ(load_scene(write(text(given))).vectors("exchange"), (rows{{0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}}));
  given["open"] = "true";
  const auto chain = load_scene(write(text(given)));
  EXPECT_EQ(chain.vectors("exchange"), (rows{{0, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0}}));
  EXPECT_EQ(chain.momentum, (std::vector<double>{0.6, 0.48, 0.64, 0.6, 0.48, 0.64, 0.6, 0.48, 0.64}));
  EXPECT_EQ(chain.vectors("sigma").size(), 9u);
  given["exchange"] = "[[0, 1, 2], [1, 0, 3], [2, 3, 0]]";
  EXPECT_EQ(load_scene(write(text(given))).vectors("exchange"), (rows{{0, 1, 2}, {1, 0, 3}, {2, 3, 0}}));
}

TEST_F(system_scenes, faults_of_spins_are_refused) {
  for (const auto* bad : {"0", "17", "2.5", "[3]", "true"}) refuse(ring(), "count", bad, {"count = ", "1 to 16"});
  for (const auto* bad : {"[[0, 1], [1, 0]]", "[[0, 1, 2], [1, 0, 3], [9, 3, 0]]", "[1, 2, 3]", "true"})
    refuse(ring(), "exchange", bad, {"exchange = ", "a symmetric 3 x 3 matrix"});
  for (const auto* bad : {"1", "'yes'", "[true]"}) refuse(ring(), "open", bad, {"open = ", "true or false"});
  for (const auto* bad : {"[1, 0, 0, 0, 1, 0]", "[1, 0, 0, 0, 0, 0, 0, 0, 1]", "[0, 0, 0]", "1.0"})
    refuse(ring(), "momentum", bad, {"momentum = ", "three finite numbers, or 9 of them, no spin zero"});
  refuse(ring(), "sigma", "[1, 2, 3]", {"sigma = ", "9 of them"});
  refuse(ring(), "theta", "true", {"theta = ", ">= 0"});
}

// A Casimir and an energy that are zero at the start are measured by what they could be.
TEST_F(system_scenes, what_vanishes_at_the_start_has_a_size) {
  auto level = top();
  level["momentum"] = "[0.3, -0.4, 0, 0, 0, 1]";
  const auto s = bind_scene(load_scene(write(text(level))));
  EXPECT_EQ(s.model->casimirs(s.scene.momentum), (std::vector<double>{1, 0}));
  EXPECT_EQ(s.model->casimir_sizes(s.scene.momentum), (std::vector<double>{1, std::sqrt(1.25)}));
  auto across = ring();
  across["count"] = "2";
  across["momentum"] = "[1, 0, 0, 0, 0, 1]";
  const auto pair = bind_scene(load_scene(write(text(across))));
  EXPECT_EQ(pair.model->energy(pair.scene.momentum), 0);
  EXPECT_DOUBLE_EQ(polhode::energy_size(pair), std::sqrt(2.0) * 0.5);
  const auto paper = bind_scene(load_scene("paper"));
  EXPECT_EQ(polhode::energy_size(paper), paper.model->energy(paper.scene.momentum));
}

TEST_F(system_scenes, faults_of_maxwell_and_bloch_are_refused) {
  const keys given{{"system", "'maxwell_bloch'"},
                   {"theta", "0.3"},
                   {"sigma", "0.4"},
                   {"horizon", "2.0"},
                   {"momentum", "[0.5, 0.6, 0.8]"}};
  for (const auto* bad : {"[0.5, 0, 0]", "[0.6, 0.8]"})
    refuse(given, "momentum", bad, {"momentum = ", "three finite numbers, the last two not both zero"});
  refuse(given, "inertia", "[1, 2, 3]", {"inertia = ", "unknown key"});
}

// Two integrals by sums: over x_1, a normal number, and over the angle.
TEST_F(system_scenes, the_gibbs_law_of_maxwell_and_bloch_is_that_of_a_pendulum) {
  const auto s = load_scene("maxwell_bloch");
  const double beta = 2 * 0.3 / 0.16;
  double total = 0, inversion = 0, square = 0;
  for (int i = 0; i < 400; ++i) {
    const double x3 = std::cos(2 * M_PI * i / 400), mass = std::exp(-beta * x3);
    total += mass;
    inversion += mass * x3;
    square += mass * (1 - x3 * x3);
  }
  const auto mean = [&](const char* name) { return polhode::reference(s, {"gibbs", name, {}, 0}).value; };
  EXPECT_NEAR(mean("x3"), inversion / total, 1e-12);
  EXPECT_NEAR(mean("x2^2"), square / total, 1e-12);
  EXPECT_NEAR(mean("x1^2"), 1 / beta, 1e-15);
  EXPECT_NEAR(mean("energy"), 0.5 / beta + inversion / total, 1e-12);
}

TEST_F(system_scenes, the_form_of_the_noise_is_a_word) {
  auto given = spin();
  given["noise"] = "'field and damping'";
  const auto s = load_scene(write(text(given)));
  EXPECT_EQ(s.word("noise"), "field and damping");
  const auto p = *bind_scene(s).sphere();
  EXPECT_TRUE(p.covariance.isZero(0));
  ASSERT_EQ(p.varying.size(), 3u);
  EXPECT_NEAR(
      (p.varying[0].slope * Eigen::Vector3d(0.6, 0.48, 0.64) - 0.5 * 0.5 * Eigen::Vector3d(0, 0.64, -0.48)).norm(), 0,
      1e-16);  // theta Pi x sigma e_1
  given["noise"] = "'field'";
  EXPECT_EQ(load_scene(write(text(given))).word("noise"), "");
  for (const auto* bad : {"'random inertia'", "1", "true", "''"})
    refuse(spin(), "noise", bad, {"noise = ", "\"field\" or \"field and damping\" or \"random anisotropy\""});
  given["noise"] = "'random anisotropy'";
  refuse(given, "sigma", "[[1,0,0],[0,1,0],[0,0,1],[1,1,1]]", {"sigma = ", "at most three vectors"});
  refuse(own_units(), "noise", "'random anisotropy'", {"noise = ", "\"field\" or \"field and damping\""});
  refuse(so4(), "noise", "'field'", {"noise = ", "unknown key"});
}

// A random inertia moves nothing on an axis; noise inside the damping does.
TEST_F(system_scenes, where_all_noise_rests_no_law_is_unique) {
  const auto gibbs = [](const char* name) { return polhode::reference(load_scene(name), {"gibbs", "energy", {}, 0}); };
  EXPECT_THROW(gibbs("random_inertia"), polhode::input_error);
  EXPECT_LT(gibbs("thermal_spin").uncertainty, 1e-9);
}

/// sigma = sqrt(2 alpha k_B T / (1 + alpha^2 |S|^2)).
TEST_F(system_scenes, noise_inside_the_damping_has_the_temperature_that_is_asked_for) {
  auto given = own_units();
  given["noise"] = "'field and damping'";
  const auto s = load_scene(write(text(given)));
  EXPECT_NEAR(s.vectors("sigma")[1][1], std::sqrt(2 * 0.2 * 0.4 / 1.04), 1e-15);
}

TEST_F(system_scenes, faults_of_vortices_are_refused) {
  for (const auto* bad : {"[2, 0]", "[]", "2.0", "[[2], [-1]]", "[1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1,1]"})
    refuse(two_vortices(), "strengths", bad, {"strengths = ", "1 to 16 finite numbers, none of them 0"});
  refuse(two_vortices(), "strengths", "[2, -1, 1]", {"momentum = ", "9 finite numbers, |mu_i| = |Gamma_i|"});
  for (const auto* bad : {"[0, 0, -2]", "[0, 0, -2, 0.6, 0, 0.9]", "[0, 0, -2, 0, 0, 0]", "[0, 0, -2, 0, 0, 1]"})
    refuse(two_vortices(), "momentum", bad, {"momentum = ", "six finite numbers", "no two vortices in one place"});
  refuse(two_vortices(), "sigma", "[1, 2, 3]", {"sigma = ", "six of them"});
  refuse(two_vortices(), "exchange", "1.0", {"exchange = ", "unknown key"});
}

// Of two, u = x_1.x_2 has the density (1 - u)^a, a = 2 theta Gamma_1 Gamma_2 / 4 pi sigma^2: E[h] by a sum over u.
TEST_F(system_scenes, the_gibbs_law_of_two_vortices_is_a_power) {
  auto given = two_vortices();
  given["strengths"] = "[2, 1]";
  given["momentum"] = "[0, 0, -2, -0.6, 0, -0.8]";
  given["theta"] = "3.0";
  const auto mean = [&] {
    return polhode::reference(load_scene(write(text(given))), {"gibbs", "energy", {}, 0}).value;
  };
  const double a = 2 * 3.0 * 2 / (4 * M_PI * 0.25);
  double total = 0, sum = 0;
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double gap = 2 * (i + 0.5) / n, mass = std::pow(gap, a);
    total += mass;
    sum -= mass * 2 / (4 * M_PI) * std::log(gap);
  }
  EXPECT_NEAR(mean(), sum / total, 1e-8);
  given["strengths"] = "[2, -1]";  // a < -1
  given["momentum"] = "[0, 0, -2, 0.6, 0, 0.8]";
  EXPECT_THROW(mean(), polhode::input_error);
  given["theta"] = "0.5";  // a = -2/pi: it can be normalised
  EXPECT_NEAR(mean(), 2 / (4 * M_PI) * (std::log(2) - 1 / (1 - 2 / M_PI)), 1e-14);
  given["sigma"] = "[1, 1, 1, 0, 0, 0]";
  EXPECT_THROW(mean(), polhode::input_error);
}

TEST_F(system_scenes, faults_of_a_fluid_are_refused) {
  for (const auto* bad : {"4", "1", "7", "3.5", "[3]", "true"}) refuse(fluid(), "n", bad, {"n = ", "3 or 5"});
  refuse(fluid(), "n", "5", {"momentum = ", "24 finite numbers, not all zero"});
  refuse(fluid(), "momentum", "[0, 0, 0, 0, 0, 0, 0, 0]", {"momentum = ", "8 finite numbers, not all zero"});
  refuse(fluid(), "sigma", "[1, 2, 3]", {"sigma = ", "8 of them"});
  refuse(fluid(), "inertia", "[1, 2, 3]", {"inertia = ", "unknown key"});
}

TEST_F(system_scenes, gibbs_laws_off_the_sphere_are_known) {
  auto two = ring();
  two["count"] = "2";
  two["exchange"] = "1.0";
  two["theta"] = "0.2";
  two["sigma"] = "0.2";
  two["momentum"] = "[0, 0.6, 0.8, 1, 0, 0]";
  const auto of = [&](const keys& given, const char* name) {
    return polhode::reference(load_scene(write(text(given))), {"gibbs", name, {}, 0}).value;
  };
  EXPECT_NEAR(of(two, "energy"), -0.9000000041, 1e-10);  // k_B T = sigma^2 / 2 theta = 0.1
  auto given = top();
  given["weight"] = "1.0";
  EXPECT_NEAR(of(given, "energy"), -0.434726363524, 1e-11);  // Pi.Gamma = 1/2, beta = 4
  EXPECT_THROW(of(given, "s1_3"), polhode::input_error);
  given["sigma"] = "[1, 1, 1, 0, 0, 0]";
  EXPECT_THROW(of(given, "energy"), polhode::input_error);
}

// sigma^2 = 0.2: without exchange and dissipation a free spin's E[S_1] is exp(-sigma^2 t) times the start; under
// exchange alone E[S_1.S_2] is exp(-2 sigma^2 t) times it.
TEST_F(system_scenes, expectations_of_a_pair_are_exact) {
  auto two = ring();
  two["count"] = "2";
  two["quadratic"] = "[0, 0, 0]";
  two["field"] = "[0, 0, 0]";
  two["exchange"] = "1";
  two["theta"] = "0";
  two["sigma"] = "0.4472135954999579";
  two["momentum"] = "[0, 0.6, 0.8, 1, 0.3, 0.2]";
  const auto of = [&](const keys& given, const char* name, int degree = 0) {
    return polhode::reference(load_scene(write(text(given))), {"expectation", name, 1.5, degree});
  };
  const auto bound = of(two, "energy");
  EXPECT_NEAR(bound.value, std::exp(-0.6) * 0.34, 1e-13);
  EXPECT_GT(bound.degree, 0);
  EXPECT_EQ(bound.reason, "");
  two["exchange"] = "0";
  EXPECT_NEAR(of(two, "s1_3").value, std::exp(-0.3) * 0.8, 1e-13);
  EXPECT_NEAR(of(two, "mu_5").value, std::exp(-0.3) * 0.3, 1e-13);
  EXPECT_THROW(of(two, "s3_1"), polhode::input_error);
  EXPECT_THROW(of(two, "energy", 1), polhode::input_error);
  EXPECT_THROW(of(two, "energy", 25), polhode::input_error);
  two["count"] = "3";
  two["momentum"] = "[0, 0.6, 0.8]";
  EXPECT_THROW(of(two, "energy"), polhode::input_error);
}

// An experiment that is asked for by name and cannot answer says why.
TEST_F(system_scenes, what_has_no_exact_law_says_so) {
  const auto r = polhode::verify(load_scene("so4"), {.schemes = {"heun"}, .experiments = {"modified"}});
  ASSERT_EQ(r.skipped.size(), 1u);
  for (const auto& s : r.skipped) EXPECT_NE(s.reason.find("does not live on one"), std::string::npos) << s.reason;
  for (const auto& v : r.verdicts) EXPECT_EQ(v.kind, polhode::report::verdict_kind::skipped) << v.claim;
  try {
    polhode::reference(load_scene("so4"), {"gap", {}, {}, 0});
    FAIL();
  } catch (const polhode::input_error& e) {
    EXPECT_NE(std::string(e.what()).find("so4_body"), std::string::npos) << e.what();
  }
}

}  // namespace
