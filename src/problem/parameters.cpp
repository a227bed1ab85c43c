// SPDX-License-Identifier: Apache-2.0
#include "problem/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "problem/drives.hpp"

namespace polhode {
namespace {

using rows = report::number_rows;
using report::shape;
using row = std::vector<double>;

template <class Test>
auto vector_if(std::size_t size, Test test) {
  return [=](const rows& given, shape s) -> std::optional<rows> {
    const bool fits = s == shape::vector && given[0].size() == size && std::ranges::all_of(given[0], test);
    return fits ? std::optional(given) : std::nullopt;
  };
}

rows diagonal(const row& entries) {
  rows out(entries.size(), row(entries.size(), 0.0));
  for (std::size_t i = 0; i < entries.size(); ++i) out[i][i] = entries[i];
  return out;
}

bool all_of_size(const rows& given, std::size_t size) {
  return std::ranges::all_of(given, [&](const row& one) { return one.size() == size; });
}

std::optional<rows> symmetric(const rows& given, shape s, std::size_t size) {
  if (s == shape::vector && given[0].size() == size) return diagonal(given[0]);
  if (s != shape::vectors || given.size() != size || !all_of_size(given, size)) return std::nullopt;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (given[i][j] != given[j][i]) return std::nullopt;
  return given;
}

std::optional<rows> noise(const rows& given, shape s, std::size_t size) {
  rows out = given;
  if (s == shape::number) out = diagonal(row(size, given[0][0]));
  if (s == shape::vector && given[0].size() == size) out = diagonal(given[0]);
  if (!all_of_size(out, size)) return std::nullopt;
  std::erase_if(out, [](const row& v) { return std::ranges::all_of(v, [](double x) { return x == 0; }); });
  return out;
}

constexpr auto finite = [](double) { return true; };
constexpr auto positive = [](double x) { return x > 0; };

}  // namespace

std::string in_words(std::size_t count) {
  constexpr std::string_view words[] = {"no", "one", "two", "three", "four", "five", "six"};
  return count < std::size(words) ? std::string(words[count]) : std::to_string(count);
}

parameter_rule number_of(std::string name, std::string unit, std::string meaning) {
  return {.name = std::move(name),
          .shape = shape::number,
          .unit = std::move(unit),
          .accepts = "a finite number",
          .meaning = std::move(meaning),
          .read = [](const rows& given, shape s) { return s == shape::number ? std::optional(given) : std::nullopt; }};
}

parameter_rule number_from_zero(std::string name, std::string unit, std::string meaning) {
  auto rule = number_of(std::move(name), std::move(unit), std::move(meaning));
  rule.accepts += " >= 0";
  rule.read = [](const rows& given, shape s) {
    return s == shape::number && given[0][0] >= 0 ? std::optional(given) : std::nullopt;
  };
  return rule;
}

parameter_rule dissipation_strength(std::string unit, std::string meaning) {
  return number_from_zero(std::string(dissipation_key), std::move(unit), std::move(meaning));
}

parameter_rule vector_of(std::string name, std::size_t size, std::string unit, std::string meaning) {
  return {.name = std::move(name),
          .shape = shape::vector,
          .unit = std::move(unit),
          .accepts = fmt::format("{} finite numbers", in_words(size)),
          .meaning = std::move(meaning),
          .read = vector_if(size, finite)};
}

parameter_rule positive_vector_of(std::string name, std::size_t size, std::string unit, std::string meaning) {
  auto rule = vector_of(std::move(name), size, std::move(unit), std::move(meaning));
  rule.accepts += " > 0";
  rule.read = vector_if(size, positive);
  return rule;
}

parameter_rule nonzero_vector_of(std::string name, std::size_t size, std::string unit, std::string meaning) {
  auto rule = vector_of(std::move(name), size, std::move(unit), std::move(meaning));
  rule.accepts += ", not all zero";
  rule.read = [any = rule.read](const rows& given, shape s) -> std::optional<rows> {
    const auto vector = any(given, s);
    return vector && std::ranges::any_of(vector->front(), [](double x) { return x != 0; }) ? vector : std::nullopt;
  };
  return rule;
}

parameter_rule symmetric_matrix(std::string name, std::size_t size, std::string unit, std::string meaning) {
  return {.name = std::move(name),
          .shape = shape::vectors,
          .unit = std::move(unit),
          .accepts = fmt::format("{0} finite numbers, or a symmetric {1} x {1} matrix of them", in_words(size), size),
          .meaning = std::move(meaning),
          .read = [size](const rows& given, shape s) { return symmetric(given, s, size); }};
}

parameter_rule one_of(std::string name, std::vector<std::string> words, std::string meaning) {
  return {.name = std::move(name),
          .shape = shape::word,
          .unit = "",
          .accepts = fmt::format("\"{}\"", fmt::join(words, "\" or \"")),
          .meaning = std::move(meaning),
          .read = [](const rows&, shape) -> std::optional<rows> { return std::nullopt; },
          .words = std::move(words)};
}

parameter_rule noise_vectors(std::size_t size, std::string unit) {
  const auto n = in_words(size);
  return {.name = std::string(noise_key),
          .shape = shape::vectors,
          .unit = std::move(unit),
          .accepts = fmt::format("a finite number, {} of them, or a list of vectors of {}", n, n),
          .meaning = "noise vectors: a number s means s e_i, numbers s_i mean s_i e_i, [] none",
          .read = [size](const rows& given, shape s) { return noise(given, s, size); }};
}

parameter_rule refined_by(std::function<parameter_rule(const report::scene&)> refined, parameter_rule general,
                          std::string accepts) {
  general.accepts = std::move(accepts);
  general.refined = std::move(refined);
  return general;
}

parameter_rule by_rows(std::function<parameter_rule(std::size_t)> rule_for, std::string accepts) {
  return refined_by([=](const report::scene& s) { return rule_for(static_cast<std::size_t>(s.number("n"))); },
                    rule_for(3), std::move(accepts));
}

}  // namespace polhode
