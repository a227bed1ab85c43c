// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/numbers.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace polhode::report {

std::string shortest(std::optional<double> number) { return finite(number) ? fmt::format("{}", *number) : ""; }

double rounded(double number, int digits) {
  const auto text = fmt::format("{:.{}e}", number, digits - 1);
  double out = number;
  std::from_chars(text.data(), text.data() + text.size(), out);
  return out;
}

double rounding(double number, int digits) {
  return number == 0 ? 0 : 0.5 * std::pow(10, std::floor(std::log10(std::fabs(number))) - (digits - 1));
}

std::string shown(std::optional<double> number) {
  if (!finite(number)) return "–";
  std::string text = fmt::format("{:.4g}", *number + 0.0);  // no reader wants a minus before zero
  const auto exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  std::size_t digits = exponent + 2;
  while (digits + 1 < text.size() && text[digits] == '0') text.erase(digits, 1);
  if (text[exponent + 1] == '+') text.erase(exponent + 1, 1);
  return text;
}

std::string shown_interval(std::optional<double> low, std::optional<double> high) {
  return finite(low) && finite(high) ? fmt::format("[{}, {}]", shown(low), shown(high)) : "";
}

std::string shown_order(std::optional<double> number) {
  return finite(number) && std::abs(*number) < 1e4 ? fmt::format("{:.3f}", *number) : shown(number);
}

std::string shown_order_interval(std::optional<double> low, std::optional<double> high) {
  return finite(low) && finite(high) ? fmt::format("[{}, {}]", shown_order(low), shown_order(high)) : "";
}

std::string shown_duration(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0 || seconds > 1e9) return "–";
  if (seconds < 60) return fmt::format("{:.3g} s", seconds);
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

}  // namespace polhode::report
