// SPDX-License-Identifier: Apache-2.0
// polhode list: what there is, and what each scheme claims.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/options/arguments.hpp"
#include "cli/terminal/layout.hpp"
#include "cli/terminal/terminal.hpp"
#include "reports/model/errors.hpp"
#include "reports/writers/json.hpp"
#include "reproduction/reproduce.hpp"
#include "run/verify.hpp"
#include "scene/builtin.hpp"
#include "scene/nearest.hpp"
#include "systems/systems.hpp"

namespace polhode::cli {
namespace {

using json = nlohmann::ordered_json;

/// A list in both forms.
struct listing {
  std::vector<entry> text;
  json objects = json::array();
};

std::string claims(const report::scheme& s) {
  const auto casimir =
      s.casimir_exact ? std::string{"kept exactly"} : fmt::format("drifts with order {}", s.casimir_order);
  return fmt::format(
      "{}, {}, {}\nstrong order: {} one noise vector, {} general\nweak order: {} one noise vector, {} isotropic, {} "
      "general\norder without noise: {}\nCasimir: {}",
      s.calculus, s.implicit ? "implicit" : "explicit", s.areas ? "needs areas" : "needs no areas", s.strong_commuting,
      s.strong_general, s.weak_one_vector, s.weak_isotropic, s.weak_general, s.deterministic_order, casimir);
}

listing schemes() {
  listing out;
  report::results only_schemes;
  only_schemes.schemes = list_schemes();
  for (const auto& s : only_schemes.schemes) out.text.push_back({s.name, s.title + '\n' + claims(s) + '\n' + s.source});
  // The writer says how a scheme reads in JSON: here as in results.json.
  out.objects = json::parse(report::to_json(only_schemes)).at("schemes");
  return out;
}

listing experiments() {
  listing out;
  for (const auto& e : list_experiments()) {
    out.text.push_back({e.name, e.question});
    out.objects.push_back({{"name", e.name}, {"question", e.question}, {"notes", e.notes}});
  }
  return out;
}

listing scenes() {
  listing out;
  for (const auto& e : builtin_scene_table()) {
    out.text.push_back({std::string{e.name}, std::string{e.title}});
    out.objects.push_back({{"name", e.name}, {"title", e.title}});
  }
  return out;
}

std::string_view name_of(report::shape s) {
  switch (s) {
    case report::shape::number: return "number";
    case report::shape::vector: return "numbers";
    case report::shape::vectors: return "list of vectors";
    case report::shape::word: return "word";
  }
  return "";
}

/// Null where a scene has to say it.
json default_of(const parameter_rule& p) {
  if (!p.words.empty()) return p.words.front();
  if (!p.fallback) return nullptr;
  if (p.shape == report::shape::number) return (*p.fallback)[0][0];
  return p.shape == report::shape::vector ? json((*p.fallback)[0]) : json(*p.fallback);
}

json described(const std::vector<parameter_rule>& all) {
  auto out = json::array();
  for (const auto& p : all)
    out.push_back({{"name", p.name},
                   {"shape", name_of(p.shape)},
                   {"unit", p.unit},
                   {"default", default_of(p)},
                   {"accepts", p.accepts},
                   {"meaning", p.meaning}});
  return out;
}

std::string in_lines(const std::vector<parameter_rule>& all) {
  std::string out;
  for (const auto& p : all)
    out += fmt::format("\n{}: {} ({}{}{})", p.name, p.meaning, p.accepts, p.unit.empty() ? "" : "; unit ", p.unit);
  return out;
}

listing list_of_systems() {
  listing out;
  for (const auto& s : systems()) {
    auto all = s.parameters;
    all.push_back(momentum_rule(s));
    std::string text = std::string(s.title) + in_lines(all);
    json object{{"name", s.name}, {"title", s.title}, {"parameters", described(all)}};
    if (!s.own_units.empty()) {
      text += "\nor, in its own units, but for momentum:" + in_lines(s.own_units);
      object["own_units"] = described(s.own_units);
    }
    out.text.push_back({std::string(s.name), text});
    out.objects.push_back(object);
  }
  return out;
}

listing list_of_observables(const std::string& system) {
  std::vector<std::string> names;
  for (const auto& s : systems()) names.emplace_back(s.name);
  listing out;
  for (const auto& o : systems()[choose("--system", system, names)].observables) {
    out.text.push_back({o.name, o.meaning});
    out.objects.push_back({{"name", o.name}, {"title", o.meaning}});
  }
  return out;
}

listing reproductions() {
  listing out;
  for (const auto& c : reproduction_cases()) {
    out.text.push_back({std::string{c.name}, std::string{c.title}});
    out.objects.push_back({{"name", c.name}, {"title", c.title}});
  }
  return out;
}

struct list_arguments {
  std::string what, format = "text", system;
};

struct subject {
  std::string name;
  listing (*list)(const list_arguments&);
};
const std::vector<subject>& subjects() {
  static const std::vector<subject> all{
      {"schemes", [](const list_arguments&) { return schemes(); }},
      {"experiments", [](const list_arguments&) { return experiments(); }},
      {"scenes", [](const list_arguments&) { return scenes(); }},
      {"observables",
       [](const list_arguments& a) { return list_of_observables(a.system.empty() ? "rigid_body" : a.system); }},
      {"systems", [](const list_arguments&) { return list_of_systems(); }},
      {"reproductions", [](const list_arguments&) { return reproductions(); }}};
  return all;
}

int run_list(const list_arguments& given) {
  std::vector<std::string> names;
  for (const auto& s : subjects()) names.push_back(s.name);
  const auto output = format_option(given.format);
  if (given.what.empty()) throw input_error(fmt::format("WHAT is missing; accepted: {}", fmt::join(names, ", ")));
  const auto& chosen = subjects()[choose("list", given.what, names)];
  if (!given.system.empty() && chosen.name != "observables")
    throw input_error(fmt::format("--system '{}': accepted with observables", given.system));
  const auto all = chosen.list(given);
  print(output == format::json ? all.objects.dump(2) + '\n' : entries(all.text, terminal_width(STDOUT_FILENO)));
  return 0;
}

}  // namespace

command add_list(CLI::App& app) {
  const auto given = std::make_shared<list_arguments>();
  auto& parser = add_command(app, "list", "Name what there is, schemes with their claims");
  add_option(parser, "WHAT", given->what, "schemes, experiments, scenes, observables, systems, reproductions", "");
  add_option(parser, "--system", given->system, "of observables: whose [rigid_body]", "NAME");
  add_option(parser, "--format", given->format, "text, json [text]", "F");
  return {&parser, [given] { return run_list(*given); }};
}

}  // namespace polhode::cli
