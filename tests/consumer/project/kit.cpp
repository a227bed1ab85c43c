// SPDX-License-Identifier: Apache-2.0
// The kit without the laboratory: two samples, one budget.
#include <cstdio>
#include <polhode/testing/alarm_budget.hpp>
#include <polhode/testing/law_test.hpp>
#include <polhode/testing/mean_test.hpp>
#include <random>

int main() {
  using namespace polhode::testkit;
  alarm_budget budget(1e-6);
  std::mt19937_64 bits(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  mean_test mean(0.5, 0.01, budget.next());
  while (mean.wants_more()) mean.add(uniform(bits));
  law_test law([](double x) { return x < 0 ? 0 : x > 1 ? 1 : x; }, 0.05, budget.next());
  while (law.wants_more()) law.add(uniform(bits));
  std::printf("%s\n%s\n", mean.reason().c_str(), law.reason().c_str());
  return mean.holds() && law.holds() ? 0 : 1;
}
