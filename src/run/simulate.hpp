// An ensemble of bodies on a scene: checks what is asked, runs it, hands plain values back.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/model/simulation.hpp"
#include "run/progress_sink.hpp"
#include "scene/scene.hpp"

namespace polhode {

struct simulate_options {
  std::string scheme, noise, start;  ///< start empty: uniform, but where all start alike for independent noise
  double dt = 0;
  std::int64_t bodies = 0;
  std::vector<double> snapshots;  ///< times; each is moved to the nearest step
  std::uint64_t seed = 1;
  int threads = 1;
  std::string isa = "auto", generator = "philox";  ///< as in verify_options
  std::string normals = "fast";                    ///< fast (float-accurate) or precise
};

/// Throws input_error, before any work, on what cannot be run.
void check_simulation(const scene&, const simulate_options&);

report::simulation simulate(const scene&, const simulate_options&, const progress_sink& = {});

}  // namespace polhode
