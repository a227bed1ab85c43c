// SPDX-License-Identifier: Apache-2.0
// Scenes to ask `polhode reference` about, and the questions: each answer is converged, each refusal is one line.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "reports/model/errors.hpp"
#include "run/reference.hpp"
#include "run/verify.hpp"
#include "scene/scene.hpp"
#include "sphere/expectations/expectation.hpp"
#include "sphere/stationary.hpp"

namespace polhode::test {

using three = std::vector<double>;

inline scene scene_of(three inertia, double theta, std::vector<three> sigma, double c = 1) {
  auto s = load_scene("paper");
  s.name = "given";
  s.vector("inertia") = inertia;
  s.number("theta") = theta;
  s.vectors("sigma") = std::move(sigma);
  s.momentum = {0.6 * c, 0.48 * c, 0.64 * c};
  return s;
}

inline std::vector<three> axes(double a, double b, double c) { return {{a, 0, 0}, {0, b, 0}, {0, 0, c}}; }
inline const std::vector<three> half = axes(0.5, 0.5, 0.5), two_vectors{{0.9, 0.2, 0}, {-0.1, 0.8, 0.5}};

/// Checked: converged, and as certain as the caller wants to compare.
inline reference_answer ask(const scene& s, reference_options o, double within = 1e-9) {
  const auto a = reference(s, o);
  EXPECT_EQ(a.reason, "") << o.quantity;
  EXPECT_LE(a.uncertainty, within) << o.quantity;
  return a;
}

inline double expected(const scene& s, const char* observable, double time) {
  return ask(s, {"expectation", observable, time, 0}).value;
}
inline double stationary_mean(const scene& s, const char* observable, int degree = 0) {
  return ask(s, {"gibbs", observable, {}, degree}).value;
}
inline double gap(const scene& s) { return ask(s, {"gap", {}, {}, 0}).value; }
inline reference_answer exponents(const scene& s) { return ask(s, {"lyapunov", {}, {}, 0}, 3e-7); }

inline std::string refusal(const scene& s, const reference_options& o) {
  try {
    reference(s, o);
  } catch (const input_error& e) {
    return e.what();
  }
  return "";
}

inline void refuses(const scene& s, const reference_options& o, const std::vector<std::string>& words) {
  const auto message = refusal(s, o);
  EXPECT_FALSE(message.empty()) << o.quantity << " was answered";
  EXPECT_EQ(message.find('\n'), message.npos) << message;
  for (const auto& word : words) EXPECT_NE(message.find(word), message.npos) << word << " in: " << message;
}

inline const std::vector<scene> kinds{
    scene_of({1, 2, 3}, 0.5, half, 3),       scene_of({1, 1, 2.5}, 0, half),
    scene_of({1, 10, 100}, 0.5, half),       scene_of({1, 2, 3}, 0.5, axes(0.2, 0.5, 0.9)),
    scene_of({1, 2, 3}, 0.5, two_vectors),   scene_of({3, 3, 1}, 0.3, axes(0.4, 0.6, 0.5)),
    scene_of({1, 2, 3}, 0.05, axes(1, 1, 1))};

}  // namespace polhode::test
