// SPDX-License-Identifier: Apache-2.0
// Results at random, to be written and read back.
#pragma once

#include <bit>
#include <cmath>
#include <iterator>
#include <optional>
#include <random>
#include <string>

#include "reports/model/results.hpp"

namespace polhode::golden {

/// Any text and any finite number, in every list.
class random_results {
 public:
  explicit random_results(unsigned seed) : random_(seed) {}

  double number() {
    const double value = std::bit_cast<double>(random_());
    return std::isfinite(value) ? value : 0.1;
  }
  std::optional<double> maybe() { return random_() % 4 == 0 ? std::nullopt : std::optional(number()); }
  std::string text() {
    static const std::string pieces[] = {"a", "Π",    "\"", "\\", "\n", "</script>", "😀", std::string(1, '\0'),
                                         ",", "\x1b", " "};
    std::string out;
    for (auto count = random_() % 6; count > 0; --count) out += pieces[random_() % std::size(pieces)];
    return out;
  }
  report::measurement measured() {
    report::measurement m{text(), text(), text(), text(), maybe(), maybe(), maybe(), text(), text(), "s" + text()};
    for (auto count = random_() % 3; count > 0; --count)
      m.at.push_back({text() + std::to_string(count), number(), text()});
    if (random_() % 2 == 0) m.set_over({text(), number(), text()});
    m.used = random_() % 2 == 0;
    return m;
  }
  report::series_id series() { return {text(), text(), text(), text(), text()}; }
  report::counters work() { return {random_(), random_(), random_()}; }
  report::results made() {
    report::results r;
    r.provenance = {text(), text(),    text(), text(), text(),   text(),  text(),
                    3,      random_(), text(), text(), number(), number()};
    using report::shape;
    r.scene = {text(),
               text(),
               {{"i", shape::vector, {{number(), number(), number()}}},
                {"theta", shape::number, {{number()}}},
                {text(), shape::vectors, {{number(), 0, 1}, {}}},
                {"none", shape::vectors, {}},
                {"said", shape::word, {}, text()}},
               {number()},
               number(),
               {1, 1LL << 60}};
    for (int i = 0; i < 5; ++i) {
      r.schemes.push_back({text(), text(), text(), text(), i % 2 == 0, i > 2, number(), number(), i, i > 1, number()});
      r.experiments.push_back({text(), text(), {text(), text()}});
      r.measurements.push_back(measured());
      r.fits.push_back({text(), text(), text(), text(), text(), number(), number(), number(), number(), text()});
      r.verdicts.push_back({text(),
                            text(),
                            text(),
                            maybe(),
                            maybe(),
                            maybe(),
                            maybe(),
                            static_cast<report::verdict_kind>(random_() % 4),
                            text(),
                            {series(), series()}});
      r.skipped.push_back({text(), text(), text(), {work(), number()}});
      r.savings.push_back({text(), text(), text(), text(), {work(), number()}});
      r.reused.push_back({text(), text(), text(), {work(), number()}});
      r.densities.push_back({text(), text(), text(), maybe(), 3, 2, {number(), 0, 1, 2.5, 1e-3, number()}});
    }
    r.done = {work(), random_(), random_(), random_()};
    return r;
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace polhode::golden
