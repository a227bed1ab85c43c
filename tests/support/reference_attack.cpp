// SPDX-License-Identifier: Apache-2.0
#include "support/reference_attack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>

#include "sphere/closed_forms/gibbs.hpp"
#include "sphere/lyapunov.hpp"
#include "sphere/spectral_gap.hpp"
#include "sphere/stationary.hpp"
#include "support/gibbs_about_the_other_axis.hpp"

namespace polhode::test {
namespace {

constexpr double is_a_hang = 60;  // seconds of processor time: what is not found by then has to be refused

/// What the reference says, told where it took too long.
template <class Ask>
reference_value timed(const std::string& quantity, const attacked_scene& s, attack_count& count, const Ask& ask) {
  const std::clock_t start = std::clock();
  const reference_value found = ask();
  const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
  count.slowest = std::max(count.slowest, seconds);
  if (seconds > is_a_hang) fmt::print("{:.0f} s: {} {}: {}\n", seconds, quantity, found.reason, words(s));
  return found;
}

void attack_gibbs(const attacked_scene& s, attack_count& count) {
  const auto& p = s.problem;
  const auto i = inertia_of(p);
  if (!s.isotropic || (i[0] == i[1] && i[1] == i[2])) return;
  const double beta = 2 * p.damping / p.covariance(0, 0);
  const gibbs_law law(i, p.radius, beta);
  const auto second = gibbs_about_the_other_axis(i, p.radius, beta);
  ++count.tried;
  std::array<std::size_t, 3> order{0, 1, 2};
  std::ranges::sort(order, [&](auto a, auto b) { return i[a] < i[b]; });
  for (std::size_t k = 0; k < 4; ++k) {
    const double value = k < 3 ? law.mean_square(int(order[k])) : law.excess_energy();
    count_answer(count, fmt::format("gibbs {}", k), s, {value, law.relative_uncertainty() * std::fabs(value)},
                 {{second[k], 1e-15 * second[k]}});
  }
}

/// The median; 0 of none.
double middle_of(std::vector<double> all) {
  if (all.empty()) return 0;
  const auto middle = all.begin() + std::ssize(all) / 2;
  std::ranges::nth_element(all, middle);
  return *middle;
}

}  // namespace

void count_answer(attack_count& count, const std::string& what, const attacked_scene& s, const reference_value& found,
                  const opinions& seconds) {
  ++count.answered;
  bool checked = false, apart = false, wrong = false;
  double sharpest = HUGE_VAL;
  for (const second_opinion& second : seconds) {
    if (!std::isfinite(second.value) || !std::isfinite(second.uncertainty)) continue;
    checked = true;
    sharpest = std::min(sharpest, (found.uncertainty + second.uncertainty) / std::fabs(*found.value));
    apart = apart || second.another_kind;
    const double error = std::max(0.0, std::fabs(*found.value - second.value) - second.uncertainty);
    count.worst = std::max(count.worst, error / std::max(found.uncertainty, 1e-300));
    if (error <= found.uncertainty) continue;
    wrong = true;
    fmt::print("wrong: {} {:.15g} +- {:.2g}, degree {}, second{} {:.15g} +- {:.2g}: {}\n", what, *found.value,
               found.uncertainty, found.degree, second.another_kind ? ", of another kind," : "", second.value,
               second.uncertainty, words(s));
  }
  if (checked) count.sees.push_back(sharpest);
  count.checked += checked;
  count.apart += apart;
  count.wrong += wrong;
}

reference_value asked(const std::string& quantity, const attacked_scene& s, const std::string& observable) {
  const auto& p = s.problem;
  const auto f = *named_observable(observable, p);
  const double size = observable == "energy" ? f(s.start) : supremum_of(p, f), rate = p.covariance.trace();
  if (quantity == "mean") return stationary_mean(p, f, 1e-11 * size);
  if (quantity == "expectation") return expectation(p, f, s.start, s.time, 1e-11 * size);
  if (quantity == "gap") return spectral_gap(p, 1e-9 * rate);
  const auto answer = lyapunov(p, 1e-6 * p.radius / std::ranges::min(inertia_of(p)));
  return {answer.lambda1, answer.uncertainty, answer.degree, answer.reason};
}

opinions opinions_on(const std::string& quantity, const attacked_scene& s, const std::string& observable,
                     const reference_value& found, bool dear) {
  if (quantity == "mean") return opinions_of_mean(s, *named_observable("energy", s.problem), found.degree, dear);
  if (quantity == "expectation") return opinions_of_expectation(s, observable, found.degree, dear);
  if (quantity == "gap") return found.degree > 0 ? opinions_of_gap(s, *found.value, found.degree, dear) : opinions{};
  return opinions_of_lambda1(s, found.degree);
}

void attack(const std::string& quantity, const attacked_scene& s, attack_count& count, bool dear,
            const std::string& observable) {
  if (quantity == "gibbs") return attack_gibbs(s, count);
  const auto found = timed(quantity, s, count, [&] { return asked(quantity, s, observable); });
  ++count.tried;
  if (!found.value || (!found.reason.empty() && found.uncertainty > 0.1 * std::fabs(*found.value))) {
    ++count.refused;
    return;
  }
  count_answer(count, quantity + " of " + observable, s, found, opinions_on(quantity, s, observable, found, dear));
}

std::string attack_table(const std::map<std::string, attack_count>& counts) {
  std::string text = fmt::format("{:<18} {:>7} {:>9} {:>8} {:>8} {:>13} {:>6}  {:>9}  {:>15}  {:>11}  {}\n", "quantity",
                                 "tried", "answered", "refused", "checked", "another kind", "wrong", "honest",
                                 "worst error/bar", "checked to", "slowest, s");
  for (const auto& [name, n] : counts)
    text += fmt::format("{:<18} {:>7} {:>9} {:>8} {:>8} {:>13} {:>6}  {:>7.3f} %  {:>15.2g}  {:>11.1e}  {:.2g}\n", name,
                        n.tried, n.answered, n.refused, n.checked, n.apart, n.wrong,
                        100.0 * (1 - double(n.wrong) / std::max(1, n.checked)), n.worst, middle_of(n.sees), n.slowest);
  return text;
}

}  // namespace polhode::test
