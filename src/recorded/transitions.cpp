// SPDX-License-Identifier: Apache-2.0
#include "recorded/transitions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/model/errors.hpp"

namespace polhode {
namespace {

constexpr std::size_t most_intervals = 32;
constexpr double same_interval = 1e-6, rounding_of_time = 0x1p-50;  // of it; of the time

}  // namespace

void transitions::add(const recorded_state& s) {
  const auto found = last_.find(s.path);
  if (found == last_.end()) {
    last_.emplace(s.path, path_state{s.time, s.time, {s.mu.begin(), s.mu.end()}, {s.mu.begin(), s.mu.end()}});
    return;
  }
  auto& p = found->second;
  if (!(s.time > p.time))
    throw input_error(
        fmt::format("{}: path {} is at t = {} after t = {}; accepted: times that increase along a path, "
                    "and a column 'path' that tells paths apart",
                    place_of(recording_, s.place), s.path, s.time, p.time));
  if (!std::isfinite(s.time - p.time))
    throw input_error(fmt::format("{}: path {} is at t = {} after t = {}; accepted: times less than 1.79e308 apart",
                                  place_of(recording_, s.place), s.path, s.time, p.time));
  const double dt = interval_class(s.time - p.time, s.time);
  if (++intervals_[dt]; intervals_.size() > most_intervals)
    throw input_error(
        fmt::format("{}: more than {} different times from state to state; accepted: states at a few "
                    "fixed intervals",
                    place_of(recording_, s.place), most_intervals));
  take_({s.path, p.start, p.mu, s.mu, p.began, s.time, dt});
  ++count_;
  p.time = s.time;
  std::ranges::copy(s.mu, p.mu.begin());
}

double transitions::interval_class(double dt, double time) const {
  const double slack = same_interval * dt + rounding_of_time * std::fabs(time);
  const auto from = intervals_.lower_bound(dt - slack);
  return from != intervals_.end() && from->first <= dt + slack ? from->first : dt;
}

}  // namespace polhode
