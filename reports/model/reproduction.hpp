// SPDX-License-Identifier: Apache-2.0
// A published figure beside what this project finds for it. Plain values.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polhode::report {

/// agrees: what we found lies, with all of its interval, in what the published number allows. explained: it does not,
/// and the reason is stated beside it. differs: it does not, and should.
enum class agreement { agrees, explained, differs };
inline constexpr std::array agreements{agreement::agrees, agreement::explained, agreement::differs};
constexpr std::string_view name_of(agreement kind) {
  switch (kind) {
    case agreement::agrees: return "agrees";
    case agreement::explained: return "differs, explained";
    case agreement::differs: return "differs";
  }
  return "differs";
}

/// One published number. Ends of an interval that are missing are open.
struct reproduced_number {
  std::string quantity;
  std::optional<double> published;    ///< none: a bound alone was published
  std::optional<double> least, most;  ///< what the published number allows: its own digits and its own sampling
  std::optional<double> ours, low, high;
  agreement verdict = agreement::differs;
  std::string why;  ///< what the tolerance is, and why a number differs
};

/// Points of a published curve, and ours.
struct reproduced_point {
  double x;
  std::optional<double> published, ours;
};
struct reproduced_curve {
  std::string title, x, y, published, ours;  ///< what is drawn, its axes, and the names of both
  bool logarithmic = false;                  ///< both axes
  std::vector<reproduced_point> points;
};

struct reproduction {
  std::string name, title, source;
  std::string scene;  ///< as a TOML file; empty: no system that ships has this equation
  std::vector<std::string> notes;
  std::vector<reproduced_number> numbers;
  std::vector<reproduced_curve> curves = {};

  /// That of its worst number.
  agreement verdict() const {
    auto worst = agreement::agrees;
    for (const auto& n : numbers) worst = std::max(worst, n.verdict);
    return worst;
  }
};

}  // namespace polhode::report
