// SPDX-License-Identifier: Apache-2.0
#include "cli/answers/json.hpp"

#include <nlohmann/json.hpp>

namespace polhode::cli {
namespace {

using json = nlohmann::ordered_json;

json json_of(const choice& c) {
  return {{"scheme", c.scheme},
          {"dt", c.dt},
          {"predicted", c.predicted},
          {"checked", c.checked},
          {"bound", c.bound},
          {"order", c.order},
          {"cost_ns_per_unit_time", c.cost},
          {"cost_low", c.cost_low},
          {"cost_high", c.cost_high},
          {"checked_to", c.checked_to}};
}

json json_of(const observable_error& e) {
  return {{"observable", e.observable}, {"error", e.value}, {"bound", e.bound()}, {"time", e.time}};
}

json json_of(const report::verdict& v) {
  const auto maybe = [](const std::optional<double>& x) { return x ? json(*x) : json(); };
  return {{"claim", v.claim},
          {"verdict", report::name_of(v.kind)},
          {"expected", maybe(v.expected)},
          {"estimate", maybe(v.estimate)},
          {"low", maybe(v.low)},
          {"high", maybe(v.high)},
          {"reason", v.reason}};
}

}  // namespace

std::string to_json(const reference_answer& a) {
  json out;
  const auto maybe = [](const auto& x) { return x ? json(*x) : json(); };
  out["quantity"] = a.quantity;
  out["observable"] = a.observable.empty() ? json() : json(a.observable);
  out["time"] = maybe(a.time);
  out["value"] = a.value;
  out["uncertainty"] = a.uncertainty;
  out["degree"] = a.degree;
  if (a.sum) out["sum"] = *a.sum;
  if (a.dimension) out["dimension"] = *a.dimension;
  out["method"] = a.method;
  out["reason"] = a.reason.empty() ? json() : json(a.reason);
  return out.dump(2) + '\n';
}

std::string to_json(const selection& s) {
  json out{{"goal", s.question.name},
           {"tolerance", s.question.tolerance},
           {"observable", s.question.observable},
           {"time", s.question.time},
           {"unit", s.unit},
           {"scheme", nullptr}};
  if (s.winner) out.update(json_of(*s.winner));
  out["worst_observable"] = s.worst_observable ? json_of(*s.worst_observable) : json();
  out["silent_on"] = s.silent_on;
  out["tied"] = s.tied;
  out["runner_up"] = s.runner_up ? json_of(*s.runner_up) : json();
  if (!s.winner) {
    out["closest"] = s.closest ? json_of(*s.closest) : json();
    out["reason"] = s.reason;
  }
  out["rejected"] = json::array();
  for (const auto& r : s.rejected) out["rejected"].push_back({{"scheme", r.scheme}, {"reason", r.reason}});
  out["notes"] = s.notes;
  out["snippet"] = s.snippet;
  return out.dump(2) + '\n';
}

std::string to_json(const checked_recording& checked) {
  json verdicts = json::array(), estimates = json::object();
  for (const auto& v : checked.results.verdicts) verdicts.push_back(json_of(v));
  for (const auto& p : checked.equation.parameters)
    estimates[p.name] = {{"value", p.value.value},
                         {"low", p.value.low},
                         {"high", p.value.high},
                         {"scene", p.in_scene},
                         {"held", p.held}};
  const json out{{"verdicts", verdicts}, {"estimates", estimates}};
  return out.dump(2) + '\n';
}

std::string to_json(std::string_view scene, std::span<const expected_cost> costs, int threads) {
  json experiments = json::array();
  for (const auto& one : costs)
    experiments.push_back({{"name", one.experiment}, {"expected_cpu_seconds", one.cpu_seconds}});
  return json{{"scene", scene}, {"threads", threads}, {"experiments", experiments}}.dump(2);
}

}  // namespace polhode::cli
