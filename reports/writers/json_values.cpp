// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/json_values.hpp"

#include <fmt/format.h>

#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

template <class Range>
json numbers(const Range& values) {
  json list = json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

}  // namespace

json number(std::optional<double> value) { return finite(value) ? json(*value) : json(nullptr); }

json to_value(const provenance& p) {
  return {{"version", p.version},
          {"commit", p.commit},
          {"compiler", p.compiler},
          {"flags", p.flags},
          {"cpu", p.cpu},
          {"isa", p.isa},
          {"generator", p.generator},
          {"threads", p.threads},
          {"seed", p.seed},
          {"effort", p.effort},
          {"started", p.started},
          {"wall_seconds", number(p.wall_seconds)},
          {"cpu_seconds", number(p.cpu_seconds)}};
}

json to_value(const parameter& p) {
  if (p.shape == shape::word) return p.word;
  if (p.shape == shape::number) return number(p.rows[0][0]);
  if (p.shape == shape::vector) return numbers(p.rows[0]);
  json all = json::array();
  for (const auto& row : p.rows) all.push_back(numbers(row));
  return all;
}

json to_value(const scene& s) {
  json out{{"name", s.name}, {"system", s.system}};
  for (const auto& p : s.parameters) out[p.name] = to_value(p);
  out["momentum"] = numbers(s.momentum);
  out["horizon"] = number(s.horizon);
  out["steps"] = s.steps;
  return out;
}

json to_value(const scheme& s) {
  json out{{"name", s.name},
           {"title", s.title},
           {"source", s.source},
           {"calculus", s.calculus},
           {"implicit", s.implicit},
           {"areas", s.areas},
           {"claims",
            {{"strong_commuting", number(s.strong_commuting)},
             {"strong_general", number(s.strong_general)},
             {"deterministic_order", s.deterministic_order},
             {"casimir_exact", s.casimir_exact},
             {"casimir_order", number(s.casimir_order)},
             {"weak_one_vector", number(s.weak_one_vector)},
             {"weak_isotropic", number(s.weak_isotropic)},
             {"weak_general", number(s.weak_general)}}}};
  if (s.from.empty()) return out;
  out["from"] = s.from;
  out["takes"] = s.takes;
  out["measured"] = json::object();
  for (const auto& [name, order] : s.measured) out["measured"][name] = number(order);
  return out;
}

json schema_of(std::string_view name, int version) { return {{"name", std::string(name)}, {"version", version}}; }

bool begins_with_schema(std::string_view text, std::string_view name) {
  const auto expected = fmt::format("{{\"schema\":{{\"name\":\"{}\"", name);
  std::size_t matched = 0;
  for (const char c : text) {
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    if (c != expected[matched]) return false;
    if (++matched == expected.size()) return true;
  }
  return false;
}

}  // namespace polhode::report
