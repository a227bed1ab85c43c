// SPDX-License-Identifier: Apache-2.0
// Costs of the steps of two runs, each in units of its run's yardstick: how they change, and from where on that is a
// change (timings.hpp).
#pragma once

#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "reports/model/results.hpp"

namespace polhode {

/// A cost at one dt, before and after, in units of the yardsticks: its change and the standard error of that.
struct cost_change {
  double dt, change, error;
};

/// The costs of one scheme, with noise or without it.
struct cost_group {
  std::vector<cost_change> rows;
  double median = 0, threshold = 0, strain = 0;
  bool moved() const { return std::fabs(median) > threshold; }
  void take_out(double common) {
    median -= common;
    for (auto& r : rows) r.change -= common;
  }
};

using group_key = std::tuple<std::string, bool>;  // scheme, without noise

bool is_cost(const report::measurement&);

struct yardstick {
  double ns, high;  ///< median, upper quartile
};

std::optional<yardstick> yardstick_of(const report::results&);

/// By how much the state of the machine differs: what the yardstick says of it, of half of the run and of its quarter.
double difference_of_state(const yardstick&, const yardstick&);

/// By scheme and noise; unit: log of how the yardstick has changed. A step is timed once, whatever kinds of errors it
/// is held against.
std::map<group_key, cost_group> groups_of(const report::results& before, const report::results& after, double unit);

/// Sets median and threshold, on a machine in one state; z: quantile.
void judge(cost_group&, double z);

/// Where the machine was in another state, schemes are slowed by different amounts: the strain, and the threshold with
/// it.
void widen(std::map<group_key, cost_group>&, double state);

/// With noise or without.
std::vector<cost_group*> of_kind(std::map<group_key, cost_group>&, bool silent);

double median_of(std::vector<double>);

}  // namespace polhode
