#include "problem/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace polhode {
namespace {

using rows = report::number_rows;
using report::shape;
using row = std::vector<double>;

template <class Test>
auto number_if(Test test) {
  return [test](const rows& given, shape s) -> std::optional<rows> {
    return s == shape::number && test(given[0][0]) ? std::optional(given) : std::nullopt;
  };
}

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
  if (s == shape::vector) out = given[0].empty() ? rows{} : diagonal(given[0]);
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

parameter_rule positive_number(std::string name, std::string unit, std::string meaning) {
  return {std::move(name),    shape::number, std::move(unit), "a finite number > 0", std::move(meaning), role::none, {},
          number_if(positive)};
}

parameter_rule number_from_zero(std::string name, std::string unit, std::string meaning) {
  return {std::move(name),
          shape::number,
          std::move(unit),
          "a finite number >= 0",
          std::move(meaning),
          role::none,
          {},
          number_if([](double x) { return x >= 0; })};
}

parameter_rule vector_of(std::string name, std::size_t size, std::string unit, std::string meaning) {
  return {std::move(name),
          shape::vector,
          std::move(unit),
          fmt::format("{} finite numbers", in_words(size)),
          std::move(meaning),
          role::none,
          {},
          vector_if(size, finite)};
}

parameter_rule positive_vector_of(std::string name, std::size_t size, std::string unit, std::string meaning) {
  return {std::move(name),
          shape::vector,
          std::move(unit),
          fmt::format("{} finite numbers > 0", in_words(size)),
          std::move(meaning),
          role::none,
          {},
          vector_if(size, positive)};
}

parameter_rule symmetric_matrix(std::string name, std::size_t size, std::string unit, std::string meaning) {
  return {std::move(name),
          shape::vectors,
          std::move(unit),
          fmt::format("{0} finite numbers, or a symmetric {1} x {1} matrix of them", in_words(size), size),
          std::move(meaning),
          role::none,
          {},
          [size](const rows& given, shape s) { return symmetric(given, s, size); }};
}

parameter_rule noise_vectors(std::size_t size, std::string unit) {
  const auto n = in_words(size);
  return {"sigma",
          shape::vectors,
          std::move(unit),
          fmt::format("a finite number, {} of them, or a list of vectors of {}", n, n),
          "noise vectors: a number s means s e_i, numbers s_i mean s_i e_i, [] none",
          role::noise,
          {},
          [size](const rows& given, shape s) { return noise(given, s, size); }};
}

}  // namespace polhode
