// SPDX-License-Identifier: Apache-2.0
// The answers of the C++ kit to numbers from the standard input, for kit_test.py to hold the Python module against:
// a line "test arguments… : samples…" gives a line "verdict: reason".
#include <polhode/testing/bounded_mean_test.hpp>
#include <polhode/testing/law_test.hpp>
#include <polhode/testing/slope_test.hpp>
#include <polhode/testing/sprt.hpp>

#include <iostream>
#include <sstream>

namespace {

using namespace polhode::testkit;
using numbers = std::vector<double>;

numbers read(std::istream& in) {
  numbers out;
  for (std::string word; in >> word && word != ":";) out.push_back(std::stod(word));
  return out;
}

template <class Test>
void tell(Test t, const numbers& samples = {}) {
  if constexpr (requires { t.add(0.0); })
    for (double x : samples) t.add(x);
  std::cout << to_string(t.kind()) << ": " << t.reason() << '\n';
}

double normal_cdf(double x) { return std::erfc(-x / std::sqrt(2.0)) / 2; }

void answer_to(const std::string& name, const numbers& a, std::istream& in) {
  const auto samples = read(in), more = read(in);
  const auto whole = [](double x) { return static_cast<std::size_t>(x); };
  if (name == "mean") tell(mean_test(a[0], a[1], a[2], {whole(a[3]), whole(a[4])}), samples);
  if (name == "bounded") tell(bounded_mean_test(a[0], a[1], a[2], {a[5], a[6]}, {whole(a[3]), whole(a[4])}), samples);
  if (name == "law") tell(law_test(normal_cdf, a[0], a[1], whole(a[2])), samples);
  if (name == "two") tell(two_law_test(samples, more, a[0], a[1]));
  if (name == "slope") tell(slope_test(samples, more, read(in), a[0], a[1], a[2]));
  if (name == "paths") tell(slope_test::of_paths(samples, more, a[0], a[1], a[2]));
  if (name == "coin") tell(sprt::bernoulli({a[0], a[1], a[2], a[3]}, whole(a[4])), samples);
  if (name == "sprt") tell(sprt::normal({a[0], a[1], a[2], a[3]}, a[5], whole(a[4])), samples);
  if (name == "student") std::cout << text("%.9g\n", student_deviate(a[0], a[1]));
}

}  // namespace

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream in(line);
    std::string name;
    in >> name;
    const auto arguments = read(in);
    answer_to(name, arguments, in);
  }
}
