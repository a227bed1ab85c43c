// SPDX-License-Identifier: Apache-2.0
// Not of the program. Its compilation is the unit of ci/costs.json: headers of the standard library to read, and
// templates to compile, in about the proportion of the other sources. A change here changes every figure there.
#include <algorithm>
#include <functional>
#include <map>
#include <random>
#include <ranges>
#include <sstream>
#include <string>
#include <vector>

std::map<std::string, std::vector<double>> table(const std::string& text) {
  std::map<std::string, std::vector<double>> out;
  std::istringstream words(text);
  std::string name;
  for (double number; words >> name >> number;) out[name].push_back(number);
  for (auto& [key, numbers] : out) std::ranges::stable_sort(numbers, std::greater());
  return out;
}

std::vector<double> sample(unsigned seed, int n) {
  std::mt19937_64 engine(seed);
  std::normal_distribution<double> normal;
  std::vector<double> out;
  for (const double x : std::views::iota(0, n) | std::views::transform([&](int) { return normal(engine); }))
    out.push_back(x);
  return out;
}
