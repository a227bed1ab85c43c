// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/reproduction_numbers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

constexpr int most_decimals = 12;

/// To two digits.
std::string rounded(double x) { return shown(std::stod(fmt::format("{:.1e}", x))); }

/// Decimals to which an uncertainty has its digits: one where that is all of it (0.05), else two (0.047).
int decimals_of(double uncertainty) {
  const int first = static_cast<int>(std::ceil(-std::log10(uncertainty) - 1e-9));
  const double leading = uncertainty * std::pow(10, first);
  return std::fabs(leading - std::round(leading)) < 1e-6 ? first : first + 1;
}

/// Plain where the uncertainty gives no number of decimals.
std::string to_uncertainty(double value, double uncertainty) {
  if (!std::isfinite(value) || !(uncertainty > 0) || !std::isfinite(uncertainty)) return shown(value);
  const int decimals = std::min(decimals_of(uncertainty), most_decimals);
  if (std::fabs(value) < 1e-3 || std::fabs(value) >= 1e6 || decimals < 0) return shown(value);
  return fmt::format("{:.{}f}", value + 0.0, decimals);
}

std::string with_tolerance(double value, double tolerance) {
  const auto text = to_uncertainty(value, tolerance);
  return tolerance > 0 ? fmt::format("{} ± {}", text, rounded(tolerance)) : text;
}

/// What is less than that of a number of ours tells a reader nothing: a hundredth of the tolerance, or the fourth
/// digit.
double least_shown(const reproduced_number& n) {
  if (n.published && n.least && n.most) return (*n.most - *n.least) / 200;
  return std::pow(10, std::floor(std::log10(std::max(std::fabs(*n.ours), 1e-300))) - 3);
}

}  // namespace

std::string shown_published(const reproduced_number& n) {
  if (n.published) return with_tolerance(*n.published, n.most && n.least ? (*n.most - *n.least) / 2 : 0);
  if (n.least && n.most) return fmt::format("{} to {}", shown(n.least), shown(n.most));
  if (n.most) return "at most " + shown(n.most);
  return n.least ? "at least " + shown(n.least) : "–";
}

std::string shown_ours(const reproduced_number& n) {
  if (!n.ours || !n.low || !n.high) return shown(n.ours);
  const double above = *n.high - *n.ours, below = *n.ours - *n.low, half = (above + below) / 2;
  const double least = least_shown(n);
  if (half < least) return to_uncertainty(*n.ours, least);
  if (std::fabs(above - below) <= 0.2 * half) return with_tolerance(*n.ours, half);
  return fmt::format("{} {}", shown(n.ours), shown_interval(n.low, n.high));
}

std::string shown_difference(const reproduced_number& n) {
  if (n.verdict == agreement::agrees || !n.ours) return "";
  const auto from = n.published ? n.published : n.most && *n.ours > *n.most ? n.most : n.least;
  return from ? "by " + rounded(std::fabs(*n.ours - *from)) : "";
}

std::string sentence(const reproduction& r) {
  const auto count = [&](agreement kind) { return std::ranges::count(r.numbers, kind, &reproduced_number::verdict); };
  auto out = fmt::format("{} of {} agree", count(agreement::agrees), r.numbers.size());
  const auto add = [&](agreement kind, std::string_view one, std::string_view many) {
    if (const auto n = count(kind); n > 0) out += fmt::format(", {} {}", n, n == 1 ? one : many);
  };
  add(agreement::explained, "differs for the reason stated", "differ for the reason stated");
  add(agreement::differs, "should agree and does not", "should agree and do not");
  return out;
}

}  // namespace polhode::report
