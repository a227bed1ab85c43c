// SPDX-License-Identifier: Apache-2.0
#include "tests/golden/sample.hpp"

#include <cmath>
#include <limits>

namespace polhode::golden {
namespace {

using namespace report;

constexpr const char* hostile = "</script><img src=x onerror=alert(1)>";
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

measurement measured(const char* experiment, const char* scheme, const char* quantity, const char* observable) {
  measurement m;
  m.experiment = experiment;
  m.scheme = scheme;
  m.quantity = quantity;
  m.observable = observable;
  m.unit = "1";
  m.method = "sampled";
  return m;
}

// Powers of two times a prefactor: no libm, so the files are the same everywhere.
void add_strong(results& r, const char* scheme, double prefactor) {
  double dt = 0.5;
  for (int level = 0; level < 5; ++level, dt /= 2) {
    auto m = measured("strong", scheme, "error", "");
    m.set_over({step_size, dt, "time"});
    m.value = prefactor * dt;
    m.low = 0.9375 * *m.value;
    m.high = 1.0625 * *m.value;
    m.used = level > 0;
    r.measurements.push_back(m);
  }
}

void add_weak(results& r) {
  const double values[] = {-8.429e-3, -4.329e-3, 0.0, nan, 1.0 / 3.0};
  double dt = 0.5;
  for (const double value : values) {
    auto m = measured("weak", "heun", "error", "exp(pi3)");
    m.set_over({step_size, dt, "time"});
    m.value = value;
    m.method = "transfer";
    r.measurements.push_back(m);
    dt /= 2;
  }
  auto missing = measured("weak", hostile, "error", "a|b, \"c\"");
  missing.set_over({step_size, 0.1, "time"});
  missing.status = "left the shell\nafter 3 steps";
  r.measurements.push_back(missing);
  auto open = measured("weak", hostile, "error", "a|b, \"c\"");
  open.set_over({step_size, 5e-324, "time"});
  open.value = 1.7976931348623157e308;
  open.low = -infinity;
  open.high = infinity;
  r.measurements.push_back(open);
}

void add_growth(results& r) {
  double steps = 10;
  for (int level = 0; level < 4; ++level, steps *= 10) {
    auto m = measured("casimir", "lie_heun", "drift", "casimir");
    m.set_over({step_count, steps, "1"});
    m.value = 1e-16 * steps;
    m.method = "deterministic";
    r.measurements.push_back(m);
  }
  auto reference = measured("casimir", "", "drift", "casimir");
  reference.value = 2.220446049250313e-16;
  reference.method = "reference";
  r.measurements.push_back(reference);
}

// A map with a border: whole, half and no share; a border found, one beyond what was tried on either side.
void add_map(results& r) {
  const coordinate at[] = {{"theta", 0.125}, {"theta", 1}, {"theta", 8}};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4 - row; ++column) {
      auto m = measured("stability", "lie_heun", "stable_share", "");
      m.at = {at[row]};
      m.set_over({step_size, 0.25 * (1 << column), "time"});
      m.value = column < 2 ? 1 : column == 2 ? 0.5 : 0;
      if (row == 1 && column == 1) m.status = "mean <b>off</b>";
      r.measurements.push_back(m);
    }
    auto m = measured("stability", "lie_heun", "largest_stable_dt", "");
    m.at = {at[row]};
    m.unit = "time";
    if (row > 0) m.value = m.low = 0.5;
    if (row < 2) m.high = 0.53125;
    m.status = row == 2 ? "stable at every dt tried" : "first broken: a & b";
    r.measurements.push_back(m);
  }
}

void add_verdicts(results& r) {
  r.fits = {
      {"strong", "heun", "error", "", step_size, 1.0, 0.96875, 1.03125, 0.25, "dt = 0.5 dropped: pre-asymptotic"},
      {"strong", "lie_heun", "error", "", step_size, 1.0, 0.96875, 1.03125, 0.125, "dt = 0.5 dropped: pre-asymptotic"},
      {"weak", "heun", "error", "exp(pi3)", step_size, nan, nan, nan, nan, "too few levels"}};
  r.verdicts = {
      {"strong",
       "heun",
       "strong order",
       0.5,
       1.0,
       0.96875,
       1.03125,
       verdict_kind::refuted,
       "disjoint from 0.5 ± 0.07",
       {{"strong", "heun", "error", "", step_size}}},
      {"strong",
       "lie_heun",
       "strong order",
       1.0,
       1.0,
       0.96875,
       1.03125,
       verdict_kind::holds,
       "",
       {{"strong", "lie_heun", "error", "", step_size}}},
      {"strong", hostile, "strong order", 0.5, {}, {}, {}, verdict_kind::skipped, "no increments of its kind"},
      {"weak", "heun", "weak order of exp(pi3)", 1.0, nan, -infinity, infinity, verdict_kind::inconclusive,
       "too few levels"},
      {"weak", hostile, "a \"claim\", with | and\na line <b>break</b>", 1.0, 0.1, -0.0, 1e-300,
       verdict_kind::inconclusive, ""},
      {"casimir", "lie_heun", "Casimir exact", {}, {}, {}, {}, verdict_kind::holds, "below the rounding bound"},
      {"stability", "heun", "stable for 10^9 steps", {}, {}, {}, {}, verdict_kind::not_tried, "at effort thorough"}};
  r.skipped = {{"gibbs", "", "σ = 0: there is no stationary law"}, {"strong", hostile, "no increments of its kind"}};
  r.savings = {{"casimir", "", "Lévy areas <b>", "no selected scheme | asks for them", {{1'230'000, 0, 0}, 0}},
               {"energy", hostile, "noise", "σ = 0", {}}};
  r.reused = {{"strong", "heun", "2024-02-28T08:00:00Z", {{12'345'678'901, 4'000, 12}, 75.5}},
              {"strong", "lie_heun", "2024-02-28T08:00:00Z", {{12'345'678'901, 4'000, 12}, 75.5}},
              {"strong", hostile, "2024-02-27T08:00:00Z", {{}, 0.25}}};
  r.done = {{18'446'744'073'709'551'615u, 9'999, 3}, 2, 4, 3};
}

}  // namespace

results sample() {
  results r;
  r.provenance = {"0.1.0",
                  "0123abcd",
                  "g++ 12.2.0",
                  "-O2 -DNAME=\"a b\"",
                  "A CPU & its cache",
                  "v3",
                  "ars",
                  2,
                  18446744073709551615u,
                  "quick",
                  "2024-02-29T12:00:00Z",
                  83.25,
                  0.1};
  r.scene.name = hostile;
  r.scene.system = "rigid_body";
  r.scene.vector("inertia") = {1, 2, 3};
  r.scene.number("theta") = 0.5;
  r.scene.vectors("sigma") = {{0.5, 0, 0}, {0, 0.1, 0}, {0, 0, 1e-7}};
  r.scene.momentum = {0.6, 0.48, 0.64};
  r.scene.horizon = 2;
  r.scene.steps = {4, 8, 16, 32, 64};
  r.schemes = {
      {"heun", "Heun, explicit", "Rümelin (1982), eq. 3", "stratonovich", false, false, 1, 0.5, 2, false, 1},
      {"lie_heun", "Lie-Heun, two-stage Munthe-Kaas", "<i>a paper</i>", "stratonovich", false, true, 1, 1, 2, true, 0},
      {hostile, "& so on", "", "ito", true, false, 0.5, 0.5, 1, false, 2}};
  r.experiments = {
      {"strong", "How fast does each path approach the exact one?", {"Levels share paths.", "5 < 6 & 6 > 5"}},
      {"weak", "How fast do expectations?", {}},
      {"casimir", "Does it stay on its orbit?", {}},
      {"gibbs", "Is its stationary law the Gibbs law?", {}}};
  add_strong(r, "heun", 0.25);
  add_strong(r, "lie_heun", 0.125);
  add_weak(r);
  add_growth(r);
  add_map(r);
  add_verdicts(r);
  return r;
}

results sample_named(const char* scene) {
  auto r = sample();
  r.scene.name = scene;
  return r;
}

}  // namespace polhode::golden
