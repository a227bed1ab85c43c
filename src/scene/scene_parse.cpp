#include "scene/scene_parse.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>

#include "reports/model/errors.hpp"
#include "scene/nearest.hpp"
#include "scene/text.hpp"
#include "systems/systems.hpp"

namespace polhode {
namespace {

using triple = std::array<double, 3>;
constexpr std::size_t longest_name = 100, most_levels = 64;
constexpr std::int64_t most_steps = 1'000'000'000;

std::vector<std::string> system_names() {
  std::vector<std::string> names;
  for (const auto& system : systems()) names.emplace_back(system.name);
  return names;
}

/// Every key of a scene and what it accepts: said in each error about that key.
struct key_rule {
  std::string key, accepted;
};
const std::vector<key_rule>& rules() {
  static const std::vector<key_rule> all{
      {"name", fmt::format("text of 1 to {} bytes without control characters", longest_name)},
      {"system", fmt::format("{}", fmt::join(system_names(), ", "))},
      {"inertia", "three finite numbers > 0"},
      {"theta", "a finite number >= 0"},
      {"sigma", "a finite number, three of them, or a list of vectors of three"},
      {"momentum", "three finite numbers, not all zero"},
      {"horizon", "a finite number > 0"},
      {"steps", fmt::format("1 to {} strictly increasing integers from 1 to {}", most_levels, most_steps)}};
  return all;
}

std::vector<std::string> keys() {
  std::vector<std::string> names;
  for (const auto& rule : rules()) names.push_back(rule.key);
  return names;
}

std::optional<double> number(const toml::node& node) {
  double value = NAN;
  if (const auto* integer = node.as_integer()) value = static_cast<double>(integer->get());
  if (const auto* real = node.as_floating_point()) value = real->get();
  return std::isfinite(value) ? std::optional{value} : std::nullopt;
}

std::optional<triple> vector_of_three(const toml::node& node) {
  const auto* array = node.as_array();
  if (array == nullptr || array->size() != 3) return {};
  triple out{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto entry = number((*array)[i]);
    if (!entry) return {};
    out[i] = *entry;
  }
  return out;
}

bool is_zero(const triple& v) { return v == triple{}; }
using noise_vectors = std::vector<triple>;
noise_vectors along_axes(const triple& s) { return {{s[0], 0, 0}, {0, s[1], 0}, {0, 0, s[2]}}; }

std::optional<noise_vectors> noise_as_given(const toml::node& node) {
  if (const auto s = number(node)) return along_axes({*s, *s, *s});
  if (const auto s = vector_of_three(node)) return along_axes(*s);
  const auto* array = node.as_array();
  if (array == nullptr) return {};
  noise_vectors out;
  for (const auto& entry : *array) {
    const auto vector = vector_of_three(entry);
    if (!vector) return {};
    out.push_back(*vector);
  }
  return out;
}

std::optional<noise_vectors> noise(const toml::node& node) {
  auto vectors = noise_as_given(node);
  if (vectors) std::erase_if(*vectors, is_zero);
  return vectors;
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

std::string shown(const toml::node& node) {
  std::ostringstream text;
  node.visit([&](const auto& concrete) { text << concrete; });
  return one_line(text.str(), 60);
}

/// One table, read key by key; each fault is refused by file, line, key and value.
class reader {
 public:
  reader(std::string_view source, const toml::table& table) : source_{source}, table_{table} {
    if (table.empty())
      throw input_error(fmt::format("{}: holds no keys; accepted: {}", source_, fmt::join(keys(), ", ")));
    const auto known = keys();
    for (const auto& [key, node] : table) {
      if (std::ranges::find(known, key.str()) != known.end()) continue;
      throw input_error(fmt::format("{}:{}: {} = {}: unknown key{}; accepted: {}", source_, key.source().begin.line,
                                    one_line(key.str(), 40), shown(node), did_you_mean(key.str(), known),
                                    fmt::join(known, ", ")));
    }
  }

  bool has(std::string_view key) const { return table_.contains(key); }

  template <class Parse>
  auto read(std::string_view key, Parse parse, const std::vector<std::string>& known = {}) const {
    const auto& accepted = std::ranges::find(rules(), key, &key_rule::key)->accepted;
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
};

std::optional<std::string> text(const toml::node& node) { return node.value_exact<std::string>(); }

toml::table parse_table(std::string_view text, std::string_view source) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error& fault) {
    throw input_error(
        fmt::format("{}:{}: not TOML: {}", source, fault.source().begin.line, one_line(fault.description(), 200)));
  }
}

}  // namespace

scene parse_scene(std::string_view source_text, std::string_view source, std::string_view default_name) {
  const auto table = parse_table(source_text, source);
  const reader keys_of{source, table};
  const auto systems = system_names();
  const auto positive = [](double x) { return x > 0; };
  const auto is_system = [&](const std::string& name) { return std::ranges::find(systems, name) != systems.end(); };
  const auto all_positive = [&](const triple& v) { return std::ranges::all_of(v, positive); };
  const auto not_zero = [](const triple& v) { return !is_zero(v); };

  scene out;
  out.name = default_name;
  if (keys_of.has("name")) out.name = keys_of.read("name", [](auto& n) { return only_if(text(n), is_name); });
  if (!is_name(out.name))
    throw input_error(fmt::format("{}: name is missing and the file's own does not do; accepted: {}", source,
                                  rules().front().accepted));
  out.system = keys_of.read(
      "system", [&](auto& n) { return only_if(text(n), is_system); }, systems);
  out.inertia = keys_of.read("inertia", [&](auto& n) { return only_if(vector_of_three(n), all_positive); });
  out.theta = keys_of.read("theta", [](auto& n) { return only_if(number(n), [](double x) { return x >= 0; }); });
  out.sigma = keys_of.read("sigma", noise);
  const auto momentum = keys_of.read("momentum", [&](auto& n) { return only_if(vector_of_three(n), not_zero); });
  out.momentum.assign(momentum.begin(), momentum.end());
  out.horizon = keys_of.read("horizon", [&](auto& n) { return only_if(number(n), positive); });
  out.steps = {4, 8, 16, 32, 64};
  if (keys_of.has("steps")) out.steps = keys_of.read("steps", step_counts);
  return out;
}

}  // namespace polhode
