// SPDX-License-Identifier: Apache-2.0
#include "foreign/greeting.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "foreign/naming.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

namespace polhode::foreign {
namespace {

using json = nlohmann::json;

// JSON is copied level by level: deeper ones could take more of the stack than there is.
constexpr int most_levels = 16;

template <class T>
using choices = std::vector<std::pair<std::string_view, T>>;

/// Takes the members of an object one by one: what is left at the end is not known.
class members {
 public:
  members(const json& from, std::string where) : left_(from), where_(std::move(where)) {}

  [[noreturn]] void refuse(const std::string& key, const std::string& accepted) const {
    throw input_error(
        fmt::format("{}: {} = {}: accepted: {}", where_, key, one_line(left_.at(key).dump(), 80), accepted));
  }
  void take(const std::string& key, std::string& to) {
    read(key, [&](const json& v) { v.is_string() ? void(to = one_line(v.get<std::string>())) : refuse(key, "text"); });
  }
  void take(const std::string& key, bool& to) {
    read(key, [&](const json& v) { v.is_boolean() ? void(to = v) : refuse(key, "true, false"); });
  }
  void take(const std::string& key, double& to) {
    read(key, [&](const json& v) { v.is_number() ? void(to = v) : refuse(key, "a number"); });
  }
  template <class T>
  void take(const std::string& key, T& to, const choices<T>& known) {
    read(key, [&](const json& v) {
      std::string names;
      for (const auto& [name, value] : known) {
        if (v == name) return void(to = value);
        names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", name);
      }
      refuse(key, names);
    });
  }
  json take_object(const std::string& key) {
    json out = json::object();
    read(key, [&](const json& v) { v.is_object() ? void(out = v) : refuse(key, "an object"); });
    return out;
  }
  void end(const std::string& accepted) const {
    if (!left_.empty())
      throw input_error(
          fmt::format("{}: '{}' is not known; accepted: {}", where_, one_line(left_.begin().key(), 80), accepted));
  }

 private:
  template <class Read>
  void read(const std::string& key, Read reader) {
    if (!left_.contains(key)) return;
    reader(left_[key]);
    left_.erase(key);
  }

  json left_;
  std::string where_;
};

claims read_claims(const json& from, const std::string& where) {
  claims c;
  members all(from, where + ": claims");
  const std::array<std::pair<const char*, double*>, 7> orders{{{"strong_commuting", &c.strong_commuting},
                                                               {"strong_general", &c.strong_general},
                                                               {"weak_one_vector", &c.weak_one_vector},
                                                               {"weak_isotropic", &c.weak_isotropic},
                                                               {"weak_general", &c.weak_general},
                                                               {"deterministic", &c.deterministic},
                                                               {"casimir_deterministic", &c.casimir_deterministic}}};
  std::string names = "casimir";
  for (const auto& [key, value] : orders) {
    all.take(key, *value);
    names += std::string(", ") + key;
  }
  if (from.contains("casimir") && from["casimir"].is_string())
    all.take("casimir", c.casimir, choices<double>{{"kept", kept}});
  else
    all.take("casimir", c.casimir);
  all.end(names);
  return c;
}

}  // namespace

description read_greeting(const std::string& line, const std::string& where, const std::string& from) {
  bool is_deep = false;
  const auto within = [&](int depth, json::parse_event_t, const json&) {
    is_deep = is_deep || depth > most_levels;
    return !is_deep;
  };
  const auto value = json::parse(line, within, false);
  if (is_deep)
    throw input_error(fmt::format("{}: greets with lists or objects more than {} deep; accepted: claims, and no other",
                                  where, most_levels));
  if (!value.is_object())
    throw input_error(fmt::format("{}: greets with '{}'; accepted: a line of JSON, {{\"polhode\":{},\"name\":…}}",
                                  where, one_line(line, 80), protocol_version));
  members all(value, where + ": greeting");
  double version = 0;
  all.take("polhode", version);
  if (version != protocol_version)
    throw input_error(fmt::format("{}: greeting: polhode = {}: accepted: version {} of the protocol", where, version,
                                  protocol_version));
  description d;
  d.from = from;
  d.apart = true;
  all.take("name", d.name);
  all.take("title", d.title);
  all.take("source", d.source);
  all.take("takes", d.takes,
           choices<noise_access>{{"increments", noise_access::increments},
                                 {"areas", noise_access::areas},
                                 {"own numbers", noise_access::own_numbers}});
  all.take("calculus", d.calculus, choices<calculus>{{"stratonovich", calculus::stratonovich}, {"ito", calculus::ito}});
  all.take("implicit", d.implicit);
  all.take("poisson", d.poisson);
  d.claims = read_claims(all.take_object("claims"), where);
  all.end("polhode, name, title, source, takes, calculus, implicit, poisson, claims");
  return checked(std::move(d), where);
}

}  // namespace polhode::foreign
