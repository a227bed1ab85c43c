// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/reproduction_json.hpp"

#include "reports/writers/json_values.hpp"

namespace polhode::report {
namespace {

json reproduction_value(const reproduced_number& n) {
  const bool even = n.published && n.least && n.most;
  return {{"quantity", n.quantity},
          {"published", number(n.published)},
          {"tolerance", even ? number((*n.most - *n.least) / 2) : json()},
          {"least", number(n.least)},
          {"most", number(n.most)},
          {"ours", number(n.ours)},
          {"low", number(n.low)},
          {"high", number(n.high)},
          {"verdict", name_of(n.verdict)},
          {"why", n.why}};
}

json reproduction_value(const reproduced_curve& c) {
  json out{{"title", c.title},         {"x", c.x},       {"y", c.y},
           {"published", c.published}, {"ours", c.ours}, {"logarithmic", c.logarithmic}};
  out["points"] = json::array();
  for (const auto& p : c.points)
    out["points"].push_back({{"x", number(p.x)}, {"published", number(p.published)}, {"ours", number(p.ours)}});
  return out;
}

json reproduction_value(const reproduction& r) {
  json out{{"name", r.name},
           {"title", r.title},
           {"source", r.source},
           {"verdict", name_of(r.verdict())},
           {"scene", r.scene.empty() ? json() : json(r.scene)},
           {"notes", r.notes},
           {"numbers", json::array()},
           {"curves", json::array()}};
  for (const auto& n : r.numbers) out["numbers"].push_back(reproduction_value(n));
  for (const auto& c : r.curves) out["curves"].push_back(reproduction_value(c));
  return out;
}

}  // namespace

std::string to_json(std::span<const reproduction> all) {
  json out{{"schema", schema_of(reproductions_schema_name, 1)}, {"cases", json::array()}};
  for (const auto& r : all) out["cases"].push_back(reproduction_value(r));
  return out.dump(2, ' ', false, json::error_handler_t::replace) + '\n';
}

}  // namespace polhode::report
