// SPDX-License-Identifier: Apache-2.0
// Results of one experiment and one scheme, written by hand.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reports/model/results.hpp"

namespace polhode::test {

inline report::measurement number(double value, double half, const std::string& method, double dt = 0.5) {
  report::measurement m{"strong", "heun", "error", "state", value, value - half, value + half, "|mu|", method};
  m.set_over({report::step_size, dt, "time"});
  m.used = true;
  return m;
}

inline report::results with(std::vector<report::measurement> numbers, std::vector<report::verdict> verdicts = {}) {
  report::results r;
  r.scene = {"s", "rigid_body", {}, {1, 0, 0}, 2, {4}};
  r.scene.vector("inertia") = {1, 2, 3};
  r.scene.number("theta") = 0.5;
  r.scene.vectors("sigma") = {{0.5, 0, 0}};
  r.schemes.resize(1);
  r.schemes[0].name = "heun";
  r.experiments = {{"strong", "?", {}}};
  r.measurements = std::move(numbers);
  r.fits = {{"strong", "heun", "error", "state", report::step_size, 0.5, 0.4, 0.6, 1, ""}};
  r.verdicts = std::move(verdicts);
  return r;
}

}  // namespace polhode::test
