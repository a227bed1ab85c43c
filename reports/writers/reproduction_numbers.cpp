#include "reports/writers/reproduction_numbers.hpp"

#include <fmt/format.h>

#include <cmath>

#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

constexpr int most_decimals = 12;

/// To one digit more than the uncertainty has; plain where that is no number of decimals.
std::string to_uncertainty(double value, double uncertainty) {
  if (!std::isfinite(value) || !(uncertainty > 0) || !std::isfinite(uncertainty)) return shown(value);
  const int decimals = static_cast<int>(std::ceil(-std::log10(uncertainty))) + 1;
  if (std::fabs(value) < 1e-3 || std::fabs(value) >= 1e6 || decimals < 0) return shown(value);
  return fmt::format("{:.{}f}", value + 0.0, std::min(decimals, most_decimals));
}

std::string with_tolerance(double value, double tolerance) {
  const auto text = to_uncertainty(value, tolerance);
  return tolerance > 0 ? fmt::format("{} ± {}", text, fmt::format("{:.2g}", tolerance)) : text;
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
  const double above = *n.high - *n.ours, below = *n.ours - *n.low;
  if (std::fabs(above - below) <= 0.1 * (above + below)) return with_tolerance(*n.ours, (above + below) / 2);
  return fmt::format("{} {}", shown(n.ours), shown_interval(n.low, n.high));
}

std::string shown_difference(const reproduced_number& n) {
  if (n.verdict == agreement::agrees || !n.ours) return "";
  const auto from = n.published ? n.published : n.most && *n.ours > *n.most ? n.most : n.least;
  return from ? fmt::format("by {:.2g}", std::fabs(*n.ours - *from)) : "";
}

std::string sentence(const reproduction& r) {
  const auto count = [&](agreement kind) { return std::ranges::count(r.numbers, kind, &reproduced_number::verdict); };
  auto out = fmt::format("{} of {} agree", count(agreement::agrees), r.numbers.size());
  if (const auto n = count(agreement::explained)) out += fmt::format(", {} differ for the reason stated", n);
  if (const auto n = count(agreement::differs)) out += fmt::format(", {} should agree and do not", n);
  return out;
}

}  // namespace polhode::report
