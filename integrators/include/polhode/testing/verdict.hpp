// SPDX-License-Identifier: Apache-2.0
// What every test of the kit answers with: a verdict from an interval, and one line that says why.
//
// The kit is for tests of random things in anybody's suite. It needs the standard library alone. A test states how
// probable a false alarm of it may be; alarm_budget.hpp shares one probability out over a whole suite.
#pragma once

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <utility>

namespace polhode::testkit {

/// Inconclusive is never a pass.
enum class verdict { holds, refuted, inconclusive };

inline const char* to_string(verdict v) {
  return v == verdict::holds ? "holds" : v == verdict::refuted ? "refuted" : "inconclusive";
}

struct interval {
  double low = 0, high = 0;
};

/// Holds if the interval lies inside claim +- margin, refuted if disjoint from it, else inconclusive, as it is where an
/// end is not finite. An interval that misses the truth with probability alpha errs in either way with no more.
inline verdict judge(const interval& i, double claim, double margin) {
  if (!std::isfinite(i.low) || !std::isfinite(i.high)) return verdict::inconclusive;
  if (i.low > claim + margin || i.high < claim - margin) return verdict::refuted;
  return i.low >= claim - margin && i.high <= claim + margin ? verdict::holds : verdict::inconclusive;
}

/// printf into a string.
#if defined(__GNUC__)
[[gnu::format(printf, 1, 2)]]
#endif
inline std::string
text(const char* format, ...) {
  char line[400];
  std::va_list values;
  va_start(values, format);
  std::vsnprintf(line, sizeof line, format, values);
  va_end(values);
  return line;
}

/// A misuse: an exception of that kind, or where a program is compiled without exceptions a line before its end.
template <class Exception>
[[noreturn]] void refuse(const std::string& why) {
#ifdef __cpp_exceptions
  throw Exception(why);
#else
  std::fprintf(stderr, "%s\n", why.c_str());
  std::abort();
#endif
}

/// alpha: of a false alarm, in (0, 1); margin >= 0. Throws std::invalid_argument.
inline void check_claim(double claim, double margin, double alpha) {
  if (!std::isfinite(claim)) refuse<std::invalid_argument>(text("claim = %g: accepted: a finite number", claim));
  if (!(margin >= 0) || !std::isfinite(margin))
    refuse<std::invalid_argument>(text("margin = %g: accepted: 0 or a positive number", margin));
  if (!(alpha > 0 && alpha < 1))
    refuse<std::invalid_argument>(text("alpha = %g: accepted: a probability between 0 and 1", alpha));
}

class answer {
 public:
  verdict kind() const { return kind_; }
  bool holds() const { return kind_ == verdict::holds; }
  const std::string& reason() const { return reason_; }  ///< one line, with the numbers

 protected:
  void say(verdict kind, std::string reason) {
    kind_ = kind;
    reason_ = std::move(reason);
  }

 private:
  verdict kind_ = verdict::inconclusive;
  std::string reason_ = "no samples";
};

}  // namespace polhode::testkit
