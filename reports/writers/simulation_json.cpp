#include "reports/writers/simulation_json.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/writers/json.hpp"
#include "reports/writers/numbers.hpp"

namespace polhode::report {
namespace {

using json = nlohmann::ordered_json;

json number(double value) { return finite(value) ? json(value) : json(nullptr); }

json to_value(const mean_and_deviation& m) { return {{"mean", number(m.mean)}, {"deviation", number(m.deviation)}}; }

json to_value(const ensemble_state& s) {
  json out{{"time", number(s.time)}, {"step", s.step}, {"lost", s.lost}, {"energy", to_value(s.energy)}};
  for (std::size_t k = 0; k < s.components.size(); ++k) out[fmt::format("pi{}", k + 1)] = to_value(s.components[k]);
  out["casimir_change"] = number(s.casimir_change);
  return out;
}

/// Provenance, scene and scheme read as they do in results.json.
json as_in_results(const simulation& s) {
  results r;
  r.provenance = s.provenance;
  r.scene = s.scene;
  r.schemes = {s.scheme};
  return json::parse(to_json(r));
}

std::string beginning_of_ours() { return fmt::format("{{\"schema\":{{\"name\":\"{}\"", simulation_schema_name); }

}  // namespace

std::string to_json(const simulation& s) {
  auto shared = as_in_results(s);
  shared["provenance"].erase("effort");
  json out;
  out["schema"] = {{"name", std::string(simulation_schema_name)}, {"version", schema_version}};
  out["provenance"] = shared["provenance"];
  out["scene"] = shared["scene"];
  out["scheme"] = shared["schemes"][0];
  out["dt"] = s.dt;
  out["steps"] = s.steps;
  out["bodies"] = s.bodies;
  out["noise"] = s.noise;
  out["start"] = s.start;
  out["lost"] = s.final.lost;
  out["numbers_drawn"] = s.numbers_drawn;
  out["path_steps"] = s.path_steps;
  out["ns_per_path_step"] = number(s.ns_per_path_step);
  out["wall_seconds"] = number(s.provenance.wall_seconds);
  out["cpu_seconds"] = number(s.provenance.cpu_seconds);
  out["casimir_change"] = number(s.final.casimir_change);
  out["remarks"] = s.remarks;
  out["final"] = to_value(s.final);
  out["snapshots"] = json::array();
  for (const auto& snapshot : s.snapshots) out["snapshots"].push_back(to_value(snapshot.state));
  return out.dump(2, ' ', false, json::error_handler_t::replace) + '\n';
}

bool looks_like_simulation(std::string_view beginning) {
  const auto expected = beginning_of_ours();
  std::size_t matched = 0;
  for (const char c : beginning) {
    if (c == ' ' || c == '\n' || c == '\r' || c == '\t') continue;
    if (c != expected[matched]) return false;
    if (++matched == expected.size()) return true;
  }
  return false;
}

}  // namespace polhode::report
