// Reading back what json.cpp wrote: every complaint names the place in the document.
#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "reports/model/errors.hpp"
#include "reports/writers/json.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

using json = nlohmann::ordered_json;

[[noreturn]] void refuse(const std::string& where, std::string_view wanted) {
  throw input_error(fmt::format("results: {}: expected {}", where.empty() ? "the document" : where, wanted));
}

// A place in the document that knows its own name.
struct node {
  const json& value;
  std::string where;

  node operator[](const char* key) const {
    if (!value.is_object()) refuse(where, "an object");
    const auto found = value.find(key);
    const std::string inner = where.empty() ? key : where + "." + key;
    if (found == value.end()) refuse(inner, "this key to be there");
    return {*found, inner};
  }

  std::optional<double> maybe_number() const {
    if (value.is_null()) return std::nullopt;
    if (!value.is_number()) refuse(where, "a number or null");
    return value.get<double>();
  }
  double number() const { return maybe_number().value_or(std::numeric_limits<double>::quiet_NaN()); }

  template <class Integer>
  Integer integer() const {
    // The parser keeps what is not negative as unsigned, the rest as signed.
    bool inside = false;
    if (value.is_number_unsigned())
      inside = std::in_range<Integer>(value.get<std::uint64_t>());
    else if (value.is_number_integer())
      inside = std::in_range<Integer>(value.get<std::int64_t>());
    if (!inside) refuse(where, fmt::format("a whole number of at most {}", std::numeric_limits<Integer>::max()));
    return value.get<Integer>();
  }

  bool flag() const {
    if (!value.is_boolean()) refuse(where, "true or false");
    return value.get<bool>();
  }

  std::string text() const {
    if (!value.is_string()) refuse(where, "a string");
    return value.get<std::string>();
  }

  template <class Read>
  auto list(Read read) const {
    if (!value.is_array()) refuse(where, "a list");
    std::vector<decltype(read(*this))> rows;
    rows.reserve(value.size());
    for (std::size_t i = 0; i < value.size(); ++i)
      rows.push_back(read(node{value[i], fmt::format("{}[{}]", where, i)}));
    return rows;
  }

  std::array<double, 3> triple() const {
    if (!value.is_array() || value.size() != 3) refuse(where, "three numbers");
    const auto all = list([](const node& n) { return n.number(); });
    return {all[0], all[1], all[2]};
  }
};

verdict_kind kind_from(const node& n) {
  const std::string text = n.text();
  for (const auto kind :
       {verdict_kind::holds, verdict_kind::refuted, verdict_kind::inconclusive, verdict_kind::skipped})
    if (text == name_of(kind)) return kind;
  refuse(n.where, "holds, refuted, inconclusive or skipped");
}

provenance provenance_from(const node& n) {
  return {n["version"].text(),
          n["commit"].text(),
          n["compiler"].text(),
          n["flags"].text(),
          n["cpu"].text(),
          n["isa"].text(),
          n["threads"].integer<int>(),
          n["seed"].integer<std::uint64_t>(),
          n["effort"].text(),
          n["started"].text(),
          n["wall_seconds"].number(),
          n["cpu_seconds"].number()};
}

scene scene_from(const node& n) {
  scene s;
  s.name = n["name"].text();
  s.system = n["system"].text();
  s.inertia = n["inertia"].triple();
  s.theta = n["theta"].number();
  s.sigma = n["sigma"].list([](const node& one) { return one.triple(); });
  s.momentum = n["momentum"].list([](const node& one) { return one.number(); });
  s.horizon = n["horizon"].number();
  s.steps = n["steps"].list([](const node& one) { return one.integer<std::int64_t>(); });
  return s;
}

scheme scheme_from(const node& n) {
  const node claims = n["claims"];
  return {n["name"].text(),
          n["title"].text(),
          n["source"].text(),
          n["calculus"].text(),
          n["implicit"].flag(),
          n["areas"].flag(),
          claims["strong_commuting"].number(),
          claims["strong_general"].number(),
          claims["deterministic_order"].integer<int>(),
          claims["casimir_exact"].flag(),
          claims["casimir_order"].number(),
          claims["weak_one_vector"].number(),
          claims["weak_isotropic"].number(),
          claims["weak_general"].number()};
}

experiment experiment_from(const node& n) {
  return {n["name"].text(), n["question"].text(), n["notes"].list([](const node& one) { return one.text(); })};
}

measurement measurement_from(const node& n) {
  return {n["experiment"].text(), n["scheme"].text(),        n["quantity"].text(),    n["observable"].text(),
          n["dt"].maybe_number(), n["value"].maybe_number(), n["low"].maybe_number(), n["high"].maybe_number(),
          n["unit"].text(),       n["method"].text(),        n["status"].text(),      n["steps"].maybe_number(),
          n["fitted"].flag()};
}

fit fit_from(const node& n) {
  return {n["experiment"].text(), n["scheme"].text(),      n["quantity"].text(),
          n["observable"].text(), n["order"].number(),     n["low"].number(),
          n["high"].number(),     n["prefactor"].number(), n["rule"].text()};
}

verdict verdict_from(const node& n) {
  return {n["experiment"].text(),       n["scheme"].text(),           n["claim"].text(),
          n["expected"].maybe_number(), n["estimate"].maybe_number(), n["low"].maybe_number(),
          n["high"].maybe_number(),     kind_from(n["verdict"]),      n["reason"].text()};
}

skip skip_from(const node& n) { return {n["experiment"].text(), n["scheme"].text(), n["reason"].text()}; }

json parsed(std::string_view text) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& error) {
    throw input_error(fmt::format("results: not JSON, or cut short, at byte {} of {}", error.byte, text.size()));
  } catch (const json::exception&) {
    throw input_error("results: holds a number that is too large for a double");
  }
}

}  // namespace

results from_json(std::string_view text) {
  const json document = parsed(text);
  const node root{document, ""};
  const node schema = root["schema"];
  if (schema["name"].text() != schema_name)
    refuse("schema.name",
           fmt::format("\"{}\", found \"{}\"", schema_name, shortened(one_line(schema["name"].text()), 40)));
  if (const int version = schema["version"].integer<int>(); version != schema_version)
    refuse("schema.version", fmt::format("{}, found {}", schema_version, version));
  return {provenance_from(root["provenance"]),         scene_from(root["scene"]),
          root["schemes"].list(scheme_from),           root["experiments"].list(experiment_from),
          root["measurements"].list(measurement_from), root["fits"].list(fit_from),
          root["verdicts"].list(verdict_from),         root["skipped"].list(skip_from)};
}

}  // namespace polhode::report
