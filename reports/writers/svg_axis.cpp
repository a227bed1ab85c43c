#include "reports/writers/svg_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polhode::report {
namespace {

std::string superscript(int number) {
  static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string out = number < 0 ? "⁻" : "";
  for (const char c : std::to_string(std::abs(number))) out += digits[c - '0'];
  return out;
}

// "0.05" and "20", or "10⁻⁷" and "2×10⁻⁷" on an axis that reaches where plain numbers grow long.
std::string decade_label(int mantissa, int exponent, bool plain) {
  if (!plain) return (mantissa == 1 ? "10" : std::to_string(mantissa) + "×10") + superscript(exponent);
  return fmt::format("{:.{}f}", mantissa * std::pow(10, exponent), std::max(0, -exponent));
}

// The greatest of 1, 2, 5 times a power of ten that cuts the range into at least `pieces`.
double even_step(double range, int pieces) {
  const double rough = range / pieces;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {5.0, 2.0})
    if (factor * power <= rough) return factor * power;
  return power;
}

std::string even_label(double value, double step) {
  const double size = std::max(std::abs(value), step);
  if (size >= 1e5 || step < 1e-7) {
    const int digits = static_cast<int>(std::ceil(std::log10(size / step))) + 1;
    return value == 0 ? "0" : fmt::format("{:.{}g}", value, std::clamp(digits, 1, 12));
  }
  return fmt::format("{:.{}f}", value, std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9))));
}

}  // namespace

axis::axis(bool logarithmic, const std::vector<double>& values, bool tight) : logarithmic_(logarithmic) {
  bool any = false;
  for (double value : values) {
    if (!std::isfinite(value) || (logarithmic && value <= 0)) continue;
    value = logarithmic ? std::log10(value) : std::clamp(value, -1e300, 1e300);
    least_ = any ? std::min(least_, value) : value;
    most_ = any ? std::max(most_, value) : value;
    any = true;
  }
  if (tight && most_ - least_ > 1e-12 * std::max(std::abs(least_), std::abs(most_))) return;
  const double size = std::max(std::abs(least_), std::abs(most_));
  double air = 0.05 * (most_ - least_);
  if (logarithmic) air = std::max(air, 0.06);
  if (!logarithmic && air <= 1e-12 * size) air = size > 1e-300 ? 0.1 * size : 1;
  least_ -= air;
  most_ += air;
}

void axis::place_between(double from, double to) {
  from_ = from;
  to_ = to;
}

double axis::at_internal(double coordinate) const {
  const double share = (std::clamp(coordinate, least_, most_) - least_) / (most_ - least_);
  return from_ + share * (to_ - from_);
}

double axis::operator()(double value) const {
  if (!logarithmic_) return at_internal(value);
  return value > 0 ? at_internal(std::log10(value)) : from_;
}

std::vector<tick> axis::ticks() const {
  if (!logarithmic_) return even_ticks();
  auto ticks = decade_ticks();
  const auto labelled = std::count_if(ticks.begin(), ticks.end(), [](const tick& t) { return !t.label.empty(); });
  return labelled >= 2 ? ticks : even_ticks();
}

// A label a decade, or every second, third, fifth of them; within few decades also at 2 and 5.
std::vector<tick> axis::decade_ticks() const {
  const int first = static_cast<int>(std::floor(least_)), last = static_cast<int>(std::ceil(most_));
  const double span = most_ - least_;
  int stride = 1;
  for (const int wider : {2, 3, 5, 10, 20, 50, 100})
    if (span / stride > 7) stride = wider;
  const bool plain = least_ > -3 && most_ < 4;
  std::vector<tick> ticks;
  for (int exponent = first; exponent <= last; ++exponent) {
    const bool labelled = exponent % stride == 0;
    for (int mantissa = 1; mantissa <= 9; ++mantissa) {
      const double coordinate = exponent + std::log10(mantissa);
      if (coordinate < least_ || coordinate > most_ || (mantissa > 1 && span > 5)) continue;
      const bool named = mantissa == 1 ? labelled : span < 1.7 && (mantissa == 2 || mantissa == 5);
      ticks.push_back({at_internal(coordinate), named ? decade_label(mantissa, exponent, plain) : "", mantissa == 1});
    }
  }
  return ticks;
}

// Round numbers at even distances, also for a logarithmic axis too short to hold two decades' marks.
std::vector<tick> axis::even_ticks() const {
  const double low = logarithmic_ ? std::pow(10, least_) : least_, high = logarithmic_ ? std::pow(10, most_) : most_;
  const double step = even_step(high - low, 4);
  std::vector<tick> ticks;
  if (!(step > 0) || !std::isfinite(step)) return ticks;
  const double first = std::ceil(low / step - 1e-9);
  for (int i = 0; i < 20 && (first + i) * step <= high * (1 + 1e-15) + (high <= 0 ? 1e-9 * step : 0); ++i) {
    const double value = (first + i) * step;
    ticks.push_back({logarithmic_ ? at_internal(std::log10(value)) : at_internal(value), even_label(value, step)});
  }
  return ticks;
}

}  // namespace polhode::report
