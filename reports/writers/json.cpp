#include "reports/writers/json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

using json = nlohmann::ordered_json;

json number(std::optional<double> value) { return finite(value) ? json(*value) : json(nullptr); }

template <class Range>
json numbers(const Range& values) {
  json list = json::array();
  for (const double value : values) list.push_back(number(value));
  return list;
}

template <class Row, class Write>
json list_of(const std::vector<Row>& rows, Write write) {
  json list = json::array();
  for (const auto& row : rows) list.push_back(write(row));
  return list;
}

json to_value(const provenance& p) {
  return {{"version", p.version},
          {"commit", p.commit},
          {"compiler", p.compiler},
          {"flags", p.flags},
          {"cpu", p.cpu},
          {"isa", p.isa},
          {"threads", p.threads},
          {"seed", p.seed},
          {"effort", p.effort},
          {"started", p.started},
          {"wall_seconds", number(p.wall_seconds)},
          {"cpu_seconds", number(p.cpu_seconds)}};
}

json to_value(const scene& s) {
  return {{"name", s.name},
          {"system", s.system},
          {"inertia", numbers(s.inertia)},
          {"theta", number(s.theta)},
          {"sigma", list_of(s.sigma, [](const auto& vector) { return numbers(vector); })},
          {"momentum", numbers(s.momentum)},
          {"horizon", number(s.horizon)},
          {"steps", s.steps}};
}

json to_value(const scheme& s) {
  return {{"name", s.name},
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
}

json to_value(const experiment& e) { return {{"name", e.name}, {"question", e.question}, {"notes", e.notes}}; }

json to_value(const measurement& m) {
  return {{"experiment", m.experiment}, {"scheme", m.scheme},
          {"quantity", m.quantity},     {"observable", m.observable},
          {"dt", number(m.dt)},         {"steps", number(m.steps)},
          {"value", number(m.value)},   {"low", number(m.low)},
          {"high", number(m.high)},     {"unit", m.unit},
          {"method", m.method},         {"status", status_of(m)},
          {"fitted", m.fitted}};
}

json to_value(const fit& f) {
  const bool good =
      std::isfinite(f.order) && std::isfinite(f.low) && std::isfinite(f.high) && std::isfinite(f.prefactor);
  return {{"experiment", f.experiment},
          {"scheme", f.scheme},
          {"quantity", f.quantity},
          {"observable", f.observable},
          {"order", number(f.order)},
          {"low", number(f.low)},
          {"high", number(f.high)},
          {"prefactor", number(f.prefactor)},
          {"status", good ? "ok" : "not finite"},
          {"rule", f.rule}};
}

json to_value(const verdict& v) {
  return {{"experiment", v.experiment},
          {"scheme", v.scheme},
          {"claim", v.claim},
          {"expected", number(v.expected)},
          {"estimate", number(v.estimate)},
          {"low", number(v.low)},
          {"high", number(v.high)},
          {"verdict", std::string(name_of(v.kind))},
          {"reason", reason_of(v)}};
}

json to_value(const skip& s) { return {{"experiment", s.experiment}, {"scheme", s.scheme}, {"reason", s.reason}}; }

std::string compact(const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); }

// Lists one record a line: a document that can be searched and compared line by line.
std::string laid_out(const json& document) {
  std::string out = "{";
  for (const auto& [key, value] : document.items()) {
    out += (out.size() == 1 ? "\n" : ",\n") + compact(key) + ":";
    if (!value.is_array() || value.empty()) {
      out += compact(value);
      continue;
    }
    for (std::size_t i = 0; i < value.size(); ++i) out += (i == 0 ? "[\n" : ",\n") + compact(value[i]);
    out += "\n]";
  }
  return out + "\n}\n";
}

}  // namespace

std::string to_json(const results& r) {
  const auto row = [](const auto& value) { return to_value(value); };
  json document;
  document["schema"] = {{"name", std::string(schema_name)}, {"version", schema_version}};
  document["provenance"] = to_value(r.provenance);
  document["scene"] = to_value(r.scene);
  document["schemes"] = list_of(r.schemes, row);
  document["experiments"] = list_of(r.experiments, row);
  document["measurements"] = list_of(r.measurements, row);
  document["fits"] = list_of(r.fits, row);
  document["verdicts"] = list_of(r.verdicts, row);
  document["skipped"] = list_of(r.skipped, row);
  return laid_out(document);
}

bool looks_like_results(std::string_view beginning) {
  std::string expected = "{\"schema\":{\"name\":\"";
  expected += schema_name;
  expected += '"';
  std::size_t matched = 0;
  for (const char c : beginning) {
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    if (c != expected[matched]) return false;
    if (++matched == expected.size()) return true;
  }
  return false;
}

}  // namespace polhode::report
