// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/json_rows.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <ranges>
#include <system_error>

#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

verdict_kind kind_from(const node& n) {
  const std::string text = n.text();
  for (const auto kind : verdict_kinds)
    if (text == name_of(kind)) return kind;
  refuse(n.where, "holds, refuted, inconclusive, not tried or skipped");
}

json coordinate_value(const coordinate& c) { return {{"name", c.name}, {"value", number(c.value)}, {"unit", c.unit}}; }

coordinate coordinate_from(const node& n) { return {n["name"].text(), n["value"].number(), n["unit"].text()}; }

json series_value(const series_id& s) {
  return {{"experiment", s.experiment},
          {"scheme", s.scheme},
          {"quantity", s.quantity},
          {"observable", s.observable},
          {"over", s.over}};
}

series_id series_from(const node& n) {
  return {n["experiment"].text(), n["scheme"].text(), n["quantity"].text(), n["observable"].text(), n["over"].text()};
}

/// "theta=8", a word of version 1.
std::optional<coordinate> coordinate_of(std::string_view word) {
  const auto equals = word.find('=');
  if (equals == word.npos || equals == 0) return std::nullopt;
  double x = 0;
  const char* const last = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data() + equals + 1, last, x);
  if (error != std::errc() || stop != last) return std::nullopt;
  return coordinate{std::string(word.substr(0, equals)), x};
}

/// Of version 1: "theta=8", "sigma=0.5 theta=1", "sigma x 0.25"; empty where the text is no place.
std::vector<coordinate> written_into(std::string observable) {
  constexpr std::string_view factor = "sigma x ";
  const bool of_sigma = observable.starts_with(factor);
  if (of_sigma) observable.replace(0, factor.size(), "factor=");
  std::vector<coordinate> at;
  for (const auto word : std::views::split(observable, ' ')) {
    auto one = coordinate_of(std::string_view(word.begin(), word.end()));
    if (!one) return {};
    at.push_back(*std::move(one));
  }
  if (of_sigma) at.front().name = "sigma factor";
  return at;
}

void place_by_version_1(const node& n, measurement& m) {
  if (m.experiment == "stability" || m.experiment == "lyapunov") m.at = written_into(m.observable);
  if (!m.at.empty()) m.observable.clear();
  const auto named = n.maybe("abscissa") ? n["abscissa"].text() : "";
  const auto dt = n["dt"].maybe_number(), steps = n["steps"].maybe_number();
  if (dt) m.set_over({!steps && !named.empty() ? named : step_size, *dt, "time"});
  if (steps) m.set_over({named.empty() ? step_count : named, *steps});
}

}  // namespace

json to_value(const measurement& m) {
  json at = json::array();
  for (const auto& c : m.at) at.push_back(coordinate_value(c));
  return {{"experiment", m.experiment},
          {"scheme", m.scheme},
          {"quantity", m.quantity},
          {"observable", m.observable},
          {"at", at},
          {"over", m.over},
          {"value", number(m.value)},
          {"low", number(m.low)},
          {"high", number(m.high)},
          {"unit", m.unit},
          {"method", m.method},
          {"status", status_of(m)},
          {"used", m.used}};
}

measurement measurement_from(const node& n, int version) {
  measurement m{.experiment = n["experiment"].text(),
                .scheme = n["scheme"].text(),
                .quantity = n["quantity"].text(),
                .observable = n["observable"].text(),
                .value = n["value"].maybe_number(),
                .low = n["low"].maybe_number(),
                .high = n["high"].maybe_number(),
                .unit = n["unit"].text(),
                .method = n["method"].text(),
                .status = n["status"].text(),
                .used = n[version == 1 ? "fitted" : "used"].flag()};
  if (version == 1) {
    place_by_version_1(n, m);
    return m;
  }
  m.at = n["at"].list(coordinate_from);
  m.over = n["over"].text();
  if (!m.over.empty() && !m.abscissa()) refuse(n.where + ".over", "the name of one of its coordinates");
  return m;
}

json to_value(const fit& f) {
  const bool good =
      std::isfinite(f.order) && std::isfinite(f.low) && std::isfinite(f.high) && std::isfinite(f.prefactor);
  return {{"experiment", f.experiment},
          {"scheme", f.scheme},
          {"quantity", f.quantity},
          {"observable", f.observable},
          {"over", f.over},
          {"order", number(f.order)},
          {"low", number(f.low)},
          {"high", number(f.high)},
          {"prefactor", number(f.prefactor)},
          {"status", good ? "ok" : "not finite"},
          {"rule", f.rule}};
}

fit fit_from(const node& n, int version, const std::vector<measurement>& measured) {
  fit f{.experiment = n["experiment"].text(),
        .scheme = n["scheme"].text(),
        .quantity = n["quantity"].text(),
        .observable = n["observable"].text(),
        .order = n["order"].number(),
        .low = n["low"].number(),
        .high = n["high"].number(),
        .prefactor = n["prefactor"].number(),
        .rule = n["rule"].text()};
  if (version != 1) {
    f.over = n["over"].text();
    return f;
  }
  const auto points = std::ranges::find_if(measured, [&](const measurement& m) {
    return m.experiment == f.experiment && m.scheme == f.scheme && m.quantity == f.quantity &&
           m.observable == f.observable && !m.over.empty();
  });
  if (points != measured.end()) f.over = points->over;
  return f;
}

json to_value(const verdict& v) {
  json evidence = json::array();
  for (const auto& s : v.evidence) evidence.push_back(series_value(s));
  return {{"experiment", v.experiment},
          {"scheme", v.scheme},
          {"claim", v.claim},
          {"expected", number(v.expected)},
          {"estimate", number(v.estimate)},
          {"low", number(v.low)},
          {"high", number(v.high)},
          {"verdict", std::string(name_of(v.kind))},
          {"reason", reason_of(v)},
          {"evidence", evidence}};
}

verdict verdict_from(const node& n, int version) {
  verdict v{.experiment = n["experiment"].text(),
            .scheme = n["scheme"].text(),
            .claim = n["claim"].text(),
            .expected = n["expected"].maybe_number(),
            .estimate = n["estimate"].maybe_number(),
            .low = n["low"].maybe_number(),
            .high = n["high"].maybe_number(),
            .kind = kind_from(n["verdict"]),
            .reason = n["reason"].text()};
  if (version != 1) v.evidence = n["evidence"].list(series_from);
  return v;
}

}  // namespace polhode::report
