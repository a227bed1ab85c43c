// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_parse.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"
#include "scene/nearest.hpp"
#include "scene/toml_table.hpp"
#include "systems/systems.hpp"

namespace polhode {
namespace {

constexpr std::size_t longest_name = 100, most_levels = 64;
constexpr std::int64_t most_steps = 1'000'000'000;

std::vector<std::string> system_names() {
  std::vector<std::string> names;
  for (const auto& one : systems()) names.emplace_back(one.name);
  return names;
}

/// Every key of a scene and what it accepts: said in each error about that key.
struct key_rule {
  std::string key, accepted;
};

/// What the table's system takes from it: its parameters, or its own units where a key of those alone is there.
const std::vector<parameter_rule>& parameters_in(const toml::table& table, const system_entry& of) {
  const auto only_there = [&](const parameter_rule& p) {
    return table.contains(p.name) &&
           std::ranges::find(of.parameters, p.name, &parameter_rule::name) == of.parameters.end();
  };
  return std::ranges::any_of(of.own_units, only_there) ? of.own_units : of.parameters;
}

/// Of any scene, and in their place those of its system; of every system where it names none.
std::vector<key_rule> rules_for(const toml::table& table, const system_entry* system) {
  std::vector<key_rule> all{{"name", fmt::format("text of 1 to {} bytes without control characters", longest_name)},
                            {"system", fmt::format("{}", fmt::join(system_names(), ", "))}};
  for (const auto& one : systems())
    if (system == nullptr || system == &one)
      for (const auto& p : parameters_in(table, one))
        if (std::ranges::find(all, p.name, &key_rule::key) == all.end()) all.push_back({p.name, p.accepts});
  all.push_back({"momentum", momentum_rule(system != nullptr ? *system : systems().front()).accepts});
  all.push_back({"horizon", "a finite number > 0"});
  all.push_back({"steps", fmt::format("1 to {} strictly increasing integers from 1 to {}", most_levels, most_steps)});
  return all;
}

std::optional<std::vector<std::int64_t>> step_counts(const toml::node& node) {
  const auto* array = node.as_array();
  if (array == nullptr || array->empty() || array->size() > most_levels) return {};
  std::vector<std::int64_t> out;
  for (const auto& entry : *array) {
    const auto* count = entry.as_integer();
    if (count == nullptr || count->get() > most_steps || count->get() <= (out.empty() ? 0 : out.back())) return {};
    out.push_back(count->get());
  }
  return out;
}

bool is_name(std::string_view text) {
  return text.size() <= longest_name && is_plain_text(text) && text.find_first_not_of(' ') != text.npos;
}

template <class Value, class Test>
std::optional<Value> only_if(std::optional<Value> value, Test test) {
  return value && test(*value) ? value : std::nullopt;
}

std::string shown(const toml::node& node) { return one_line(as_written(node), 60); }

/// What to do about an unknown key: its line goes, or it meant another.
std::string advice(std::string_view key, const toml::node& node, const std::vector<std::string>& known) {
  const auto* list = node.as_array();
  const auto* inner = list != nullptr && !list->empty() ? list->front().as_table() : node.as_table();
  const bool holds_known =
      inner != nullptr && std::ranges::any_of(known, [&](const std::string& name) { return inner->contains(name); });
  if (key == "schema") return "; results have a schema, scenes do not: delete this line";
  if (holds_known) return "; a scene has no tables: move its keys to the top level";
  return accepted_instead(key, known);
}

/// One table, read key by key; each fault is refused by file, line, key and value.
class reader {
 public:
  reader(std::string_view source, const toml::table& table)
      : source_{source},
        table_{table},
        rules_{rules_for(table, find_system(table["system"].value_or(std::string_view{})))} {
    std::vector<std::string> known;
    for (const auto& rule : rules_) known.push_back(rule.key);
    if (table.empty())
      throw input_error(fmt::format("{}: holds no keys; accepted: {}", source_, fmt::join(known, ", ")));
    for (const auto& [key, node] : table) {
      if (std::ranges::find(known, key.str()) != known.end()) continue;
      throw input_error(fmt::format("{}:{}: {} = {}: unknown key{}", source_, key.source().begin.line,
                                    key.str().empty() ? "\"\"" : one_line(key.str(), 40), shown(node),
                                    advice(key.str(), node, known)));
    }
  }

  bool has(std::string_view key) const { return table_.contains(key); }

  template <class Parse>
  auto read(std::string_view key, Parse parse, const std::vector<std::string>& known = {}) const {
    return read(key, std::ranges::find(rules_, key, &key_rule::key)->accepted, parse, known);
  }
  template <class Parse>
  auto read(std::string_view key, const std::string& accepted, Parse parse,
            const std::vector<std::string>& known = {}) const {
    const auto* node = table_.get(key);
    if (node == nullptr) throw input_error(fmt::format("{}: {} is missing; accepted: {}", source_, key, accepted));
    if (auto value = parse(*node)) return *std::move(value);
    const auto hint = did_you_mean(node->value_or(std::string_view{}), known);
    throw input_error(fmt::format("{}:{}: {} = {}: not accepted{}; accepted: {}", source_, node->source().begin.line,
                                  key, shown(*node), hint, accepted));
  }

 private:
  std::string_view source_;
  const toml::table& table_;
  std::vector<key_rule> rules_;
};

/// Nothing for the first word, which changes nothing.
std::string read_word(const reader& keys, const parameter_rule& rule) {
  if (!keys.has(rule.name)) return "";
  const auto is_known = [&](const std::string& word) {
    return std::ranges::find(rule.words, word) != rule.words.end();
  };
  const auto word = keys.read(
      rule.name, [&](auto& n) { return only_if(text_in(n), is_known); }, rule.words);
  return word == rule.words.front() ? "" : word;
}

report::parameter read_parameter(const reader& keys, const parameter_rule& general, const report::scene& so_far) {
  const auto rule = general.refined ? general.refined(so_far) : general;
  if (rule.shape == report::shape::word) return {rule.name, rule.shape, {}, read_word(keys, rule)};
  if (rule.fallback && !keys.has(rule.name)) return {rule.name, rule.shape, *rule.fallback};
  const auto parse = [&](const toml::node& node) -> std::optional<report::number_rows> {
    if (const auto* flag = node.as_boolean())
      return rule.is_flag ? std::optional(report::number_rows{{flag->get() ? 1.0 : 0.0}}) : std::nullopt;
    const auto given = parameter_in(node);
    return given && !rule.is_flag ? rule.read(given->rows, given->shape) : std::nullopt;
  };
  return {rule.name, rule.shape, keys.read(rule.name, rule.accepts, parse)};
}

/// What the system's own units come to.
std::vector<report::parameter> from_own_units(const system_entry& of, const scene& given, std::string_view source) {
  auto out = of.from_own_units(given);
  const auto finite = [](const auto& row) {
    return std::ranges::all_of(row, [](double x) { return std::isfinite(x); });
  };
  for (const auto& p : out)
    if (!std::ranges::all_of(p.rows, finite)) {
      std::vector<std::string> names;
      for (const auto& one : of.own_units) names.push_back(one.name);
      throw input_error(
          fmt::format("{}: {}, which follows from {}, is beyond double precision; accepted: smaller numbers", source,
                      p.name, fmt::join(names, ", ")));
    }
  return out;
}

}  // namespace

scene parse_scene(std::string_view source_text, std::string_view source, std::string_view default_name) {
  const auto table = toml_table(source_text, source);
  const reader keys_of{source, table};
  const auto systems = system_names();
  const auto positive = [](double x) { return x > 0; };
  const auto is_system = [&](const std::string& name) { return std::ranges::find(systems, name) != systems.end(); };
  scene out;
  out.name = default_name;
  if (keys_of.has("name")) out.name = keys_of.read("name", [](auto& n) { return only_if(text_in(n), is_name); });
  if (!is_name(out.name))
    throw input_error(fmt::format("{}: name is missing and the file's own does not do; accepted: {}", source,
                                  rules_for(table, nullptr).front().accepted));
  out.system = keys_of.read(
      "system", [&](auto& n) { return only_if(text_in(n), is_system); }, systems);
  const auto& of = *find_system(out.system);
  const auto& rules = parameters_in(table, of);
  for (const auto& rule : rules) out.parameters.push_back(read_parameter(keys_of, rule, out));
  std::erase_if(out.parameters, [](const auto& p) { return p.shape == report::shape::word && p.word.empty(); });
  out.momentum = read_parameter(keys_of, momentum_rule(of), out).rows.front();
  if (&rules == &of.own_units) out.parameters = from_own_units(of, out, source);
  out.horizon = keys_of.read("horizon", [&](auto& n) { return only_if(number_in(n), positive); });
  out.steps = {4, 8, 16, 32, 64};
  if (keys_of.has("steps")) out.steps = keys_of.read("steps", step_counts);
  return out;
}

}  // namespace polhode
