// One noise for all bodies: the increments of one path over all steps, computed once.
#pragma once

#include <cstdint>
#include <vector>

#include <polhode/noise/address.hpp>

#include "ensemble/kernel.hpp"
#include "ensemble/model.hpp"

namespace polhode {

class shared_increments {
 public:
  /// The numbers that increment_buffer gives to the path, areas included.
  shared_increments(const model&, std::uint64_t seed, std::int64_t steps, double dt, bool with_areas, int threads,
                    noise_source = {}, std::uint64_t path = 0);

  /// Those of the paths first_path … first_path + block_lanes - 1, drawn side by side: the same numbers sooner.
  static std::vector<shared_increments> of_block(const model&, std::uint64_t seed, std::int64_t steps, double dt,
                                                 bool with_areas, noise_source, std::uint64_t first_path);

  /// Steps first_step … first_step + steps - 1.
  increment_view view(std::int64_t first_step, int steps) const;
  std::uint64_t drawn() const { return drawn_; }

  static double bytes(const model&, std::int64_t steps, bool with_areas);

 private:
  shared_increments(const model&, std::int64_t steps, bool with_areas);

  noise_layout layout_;
  std::uint64_t drawn_;
  std::vector<double> dw_, area_;
};

}  // namespace polhode
