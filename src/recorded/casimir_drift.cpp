// SPDX-License-Identifier: Apache-2.0
#include "recorded/casimir_drift.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "recorded/claims.hpp"

namespace polhode {
namespace {

constexpr double rounding = 1e-11;    // of a Casimir: long runs of schemes that keep it
constexpr double of_one_number = 16;  // a Casimir is made of products of several

}  // namespace

casimir_drift::casimir_drift(const model& m) : model_(m) {}

void casimir_drift::add(const recorded_transition& t) {
  const auto start = model_.casimirs(t.start), now = model_.casimirs(t.after), size = model_.casimir_sizes(t.start);
  largest_.resize(start.size());
  sum_.resize(start.size());
  for (std::size_t k = 0; k < start.size(); ++k) {
    const double change = (now[k] - start[k]) / size[k];
    largest_[k] = std::max(largest_[k], std::fabs(change));
    sum_[k] += change;
  }
  ++count_;
}

void casimir_drift::report(double resolution, recorder& record) const {
  const double allowed = rounding + of_one_number * resolution;
  double worst = 0, mean = 0;
  for (std::size_t k = 0; k < largest_.size(); ++k) {
    const auto name = largest_.size() == 1 ? std::string("casimir") : fmt::format("casimir_{}", k + 1);
    record.value({"largest relative change", name, "", "recorded"}, largest_[k]);
    if (largest_[k] < worst) continue;
    worst = largest_[k];
    mean = sum_[k] / count_;
  }
  report::verdict v{.expected = 0, .estimate = worst, .low = 0, .high = allowed};
  v.kind = worst <= allowed ? report::verdict_kind::holds : report::verdict_kind::refuted;
  v.reason = fmt::format("largest relative change along a path {:.2g}, {:.2g} on average; {:.2g} is what {} hide",
                         worst, mean, allowed, resolution <= 0x1p-52 ? "rounding may" : "the digits of the file");
  record.verdict(recorded_claim::casimir, std::move(v));
}

}  // namespace polhode
