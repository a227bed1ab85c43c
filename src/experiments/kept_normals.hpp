// The unit normals of whole runs, kept for those that ask for the same: half of the time of a run is drawing them.
#pragma once

#include <cstdint>
#include <list>
#include <tuple>
#include <vector>

#include "ensemble/paths.hpp"

namespace polhode {

/// Fast increments of blocks of paths, as increment_buffer fills them without areas, bit for bit. Those asked for last
/// are kept, up to a number of bytes (the newest whatever its size). For one thread.
class kept_normals {
 public:
  explicit kept_normals(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  struct run {
    std::uint64_t seed, first_path;
    std::int64_t steps;
    int channels, active;
    noise_generator generator;
    auto operator<=>(const run&) const = default;
  };
  /// [step][channel][lane]; valid until the next call.
  const std::vector<float>& of(const run&);

 private:
  struct kept {
    run key;
    std::vector<float> singles;
  };
  std::size_t most_bytes_;
  std::list<kept> all_;  // the one asked for last first
};

/// Steps first ... first + count - 1 of a run's normals, as increments over dt; counted as drawn.
increment_view increments_of(const kept_normals::run&, const std::vector<float>& singles, std::int64_t first, int count,
                             double dt);

}  // namespace polhode
