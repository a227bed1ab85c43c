// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/json_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "reports/writers/json_node.hpp"
#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

template <class Range>
json numbers(const Range& values) {
  json list = json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

/// Whatever a system calls its parameters: the keys that not every scene has.
parameter parameter_from(std::string name, const node& n) {
  const auto numbers_of = [](const node& one) { return one.list([](const node& x) { return x.finite(); }); };
  const bool is_strength = name == "theta" || name == "sigma";  // numbers in every system
  if (n.value.is_string() && !is_strength) return {std::move(name), shape::word, {}, n.text()};
  if (!n.value.is_array()) return {std::move(name), shape::number, {{n.finite()}}};
  if (!n.value.empty() && !n.value[0].is_array()) return {std::move(name), shape::vector, {numbers_of(n)}};
  return {std::move(name), shape::vectors, n.list(numbers_of)};
}

}  // namespace

std::string compact(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

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

provenance provenance_from(const node& n) {
  return {n["version"].text(),
          n["commit"].text(),
          n["compiler"].text(),
          n["flags"].text(),
          n["cpu"].text(),
          n["isa"].text(),
          n.maybe("generator") ? n["generator"].text() : "",
          n["threads"].integer<int>(),
          n["seed"].integer<std::uint64_t>(),
          n["effort"].text(),
          n["started"].text(),
          n["wall_seconds"].number(),
          n["cpu_seconds"].number()};
}

scene scene_from(const node& n) {
  constexpr std::array<std::string_view, 5> of_every_scene{"name", "system", "momentum", "horizon", "steps"};
  scene s;
  s.name = n["name"].text();
  s.system = n["system"].text();
  for (const auto& [key, value] : n.value.items())
    if (std::ranges::find(of_every_scene, key) == of_every_scene.end())
      s.parameters.push_back(parameter_from(key, {value, n.where + "." + key}));
  s.momentum = n["momentum"].list([](const node& one) { return one.finite(); });
  s.horizon = n["horizon"].finite();
  s.steps = n["steps"].list([](const node& one) { return one.integer<std::int64_t>(); });
  return s;
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
