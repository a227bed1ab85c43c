// SPDX-License-Identifier: Apache-2.0
// The result of one simulated ensemble: plain values, as in results.hpp.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "reports/model/results.hpp"

namespace polhode::report {

inline constexpr std::string_view simulation_schema_name = "polhode-simulation";

struct mean_and_deviation {
  double mean = 0, deviation = 0;  ///< the deviation is NaN for fewer than two bodies
};

/// The ensemble at one time; lost bodies are left out of the moments.
struct ensemble_state {
  double time = 0;
  std::int64_t step = 0, lost = 0;
  mean_and_deviation energy;
  std::vector<mean_and_deviation> components;
  double casimir_change = 0;  ///< the largest of any body, relative to the start
};

struct ensemble_snapshot {
  ensemble_state state;
  std::vector<std::uint32_t> counts;  ///< [z][longitude], equal areas, from z = -1 and longitude -pi
  int heights = 0, longitudes = 0;
  std::vector<std::uint32_t> picture;  ///< [z >= 0, z < 0][y][x] in Lambert's equal-area projection of each hemisphere
  int side = 0;
};

struct simulation {
  report::provenance provenance;
  report::scene scene;
  report::scheme scheme;
  double dt = 0;
  std::int64_t steps = 0, bodies = 0;
  std::string noise, start, normals;
  std::vector<std::string> components;  ///< their names; of three components none are needed
  int pictured = 0;                     ///< the first of the three whose direction the snapshots count
  std::uint64_t numbers_drawn = 0;      ///< increments and areas of the noise
  double path_steps = 0, ns_per_path_step = 0;
  double resumed_at = 0;  ///< the share of the work that an interrupted run had done; times are of the rest
  std::vector<std::string> remarks;
  std::vector<double> states;  ///< [component][body] at the end; empty where they are not kept
  ensemble_state final;
  std::vector<ensemble_snapshot> snapshots;

  std::string component(std::size_t k) const {
    return components.empty() ? "pi" + std::to_string(k + 1) : components[k];
  }
};

}  // namespace polhode::report
