// polhode list: what there is, and what each scheme claims.
#include <fmt/format.h>
#include <unistd.h>

#include <memory>
#include <nlohmann/json.hpp>

#include "cli/arguments.hpp"
#include "cli/commands.hpp"
#include "cli/layout.hpp"
#include "cli/terminal.hpp"
#include "reports/writers/json.hpp"
#include "run/verify.hpp"
#include "scene/builtin.hpp"
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

template <class Catalog>
listing catalog(const Catalog& all) {
  listing out;
  for (const auto& e : all) {
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
  }
  return "";
}

/// Null where a scene has to say it.
json default_of(const parameter_rule& p) {
  if (!p.fallback) return nullptr;
  if (p.shape == report::shape::number) return (*p.fallback)[0][0];
  return p.shape == report::shape::vector ? json((*p.fallback)[0]) : json(*p.fallback);
}

listing list_of_systems() {
  listing out;
  for (const auto& s : systems()) {
    std::string text{s.title};
    auto parameters = json::array();
    auto all = s.parameters;
    all.push_back(momentum_rule(s));
    for (const auto& p : all) {
      text += fmt::format("\n{}: {} ({}{}{})", p.name, p.meaning, p.accepts, p.unit.empty() ? "" : "; unit ", p.unit);
      parameters.push_back({{"name", p.name},
                            {"shape", name_of(p.shape)},
                            {"unit", p.unit},
                            {"default", default_of(p)},
                            {"accepts", p.accepts},
                            {"meaning", p.meaning}});
    }
    out.text.push_back({std::string(s.name), text});
    out.objects.push_back({{"name", s.name}, {"title", s.title}, {"parameters", parameters}});
  }
  return out;
}

struct subject {
  std::string name;
  listing (*list)();
};
const std::vector<subject>& subjects() {
  static const std::vector<subject> all{{"schemes", schemes},
                                        {"experiments", experiments},
                                        {"scenes", [] { return catalog(builtin_scene_table()); }},
                                        {"observables", [] { return catalog(list_observables()); }},
                                        {"systems", list_of_systems}};
  return all;
}

struct arguments {
  std::string what, format = "text";
};

int run(const arguments& given) {
  std::vector<std::string> names;
  for (const auto& s : subjects()) names.push_back(s.name);
  const auto output = format_option(given.format);
  const auto& chosen = subjects()[choice_option("list", given.what, names)];
  const auto all = chosen.list();
  print(output == format::json ? all.objects.dump(2) + '\n' : entries(all.text, terminal_width(STDOUT_FILENO)));
  return 0;
}

}  // namespace

command add_list(CLI::App& app) {
  const auto given = std::make_shared<arguments>();
  auto& parser = add_command(app, "list", "Name what there is, schemes with their claims");
  add_option(parser, "WHAT", given->what, "schemes, experiments, scenes, observables, systems", "");
  add_option(parser, "--format", given->format, "text, json [text]", "F");
  return {&parser, [given] { return run(*given); }};
}

}  // namespace polhode::cli
