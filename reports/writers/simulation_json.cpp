// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/simulation_json.hpp"

#include "reports/writers/json_values.hpp"

namespace polhode::report {
namespace {

json state_value(const mean_and_deviation& m) { return {{"mean", number(m.mean)}, {"deviation", number(m.deviation)}}; }

json state_value(const simulation& of, const ensemble_state& s) {
  json out{{"time", number(s.time)}, {"step", s.step}, {"lost", s.lost}, {"energy", state_value(s.energy)}};
  for (std::size_t k = 0; k < s.components.size(); ++k) out[of.component(k)] = state_value(s.components[k]);
  out["casimir_change"] = number(s.casimir_change);
  return out;
}

}  // namespace

std::string to_json(const simulation& s) {
  json out;
  out["schema"] = schema_of(simulation_schema_name, 1);
  out["provenance"] = to_value(s.provenance);
  out["provenance"].erase("effort");
  out["scene"] = to_value(s.scene);
  out["scheme"] = to_value(s.scheme);
  out["dt"] = s.dt;
  out["steps"] = s.steps;
  out["bodies"] = s.bodies;
  out["noise"] = s.noise;
  out["start"] = s.start;
  out["normals"] = s.normals;
  out["lost"] = s.final.lost;
  out["numbers_drawn"] = s.numbers_drawn;
  out["path_steps"] = s.path_steps;
  out["ns_per_path_step"] = number(s.ns_per_path_step);
  out["wall_seconds"] = number(s.provenance.wall_seconds);
  out["cpu_seconds"] = number(s.provenance.cpu_seconds);
  out["casimir_change"] = number(s.final.casimir_change);
  out["remarks"] = s.remarks;
  out["final"] = state_value(s, s.final);
  out["snapshots"] = json::array();
  for (const auto& snapshot : s.snapshots) out["snapshots"].push_back(state_value(s, snapshot.state));
  return out.dump(2, ' ', false, json::error_handler_t::replace) + '\n';
}

bool looks_like_simulation(std::string_view beginning) { return begins_with_schema(beginning, simulation_schema_name); }

}  // namespace polhode::report
