#include "experiments/kept_normals.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "ensemble/normal_block.hpp"
#include "ensemble/work_counters.hpp"

namespace polhode {

const std::vector<float>& kept_normals::of(const run& key) {
  const auto found = std::ranges::find(all_, key, &kept::key);
  if (found != all_.end()) {
    all_.splice(all_.begin(), all_, found);
    return all_.front().singles;
  }
  const auto floats = static_cast<std::size_t>(key.steps * key.channels * block_lanes);
  std::size_t bytes = floats * sizeof(float);
  for (const auto& one : all_) bytes += one.singles.size() * sizeof(float);
  for (; bytes > most_bytes_ && !all_.empty(); all_.pop_back()) bytes -= all_.back().singles.size() * sizeof(float);
  auto& made = all_.emplace_front(key, std::vector<float>(floats)).singles;
  fill_normals({key.seed,
                noise_kind::increment,
                key.first_path,
                0,
                static_cast<int>(key.steps),
                key.channels,
                key.active,
                1,
                nullptr,
                {key.generator, noise_quality::fast},
                made.data()});
  return made;
}

increment_view increments_of(const kept_normals::run& of, const std::vector<float>& singles, std::int64_t first,
                             int count, double dt) {
  count_normals(static_cast<std::uint64_t>(count * of.active * block_lanes));
  const auto step = static_cast<std::size_t>(of.channels * block_lanes);
  return {dt,
          count,
          {},
          {},
          std::span(singles).subspan(static_cast<std::size_t>(first) * step, static_cast<std::size_t>(count) * step),
          std::sqrt(dt)};
}

}  // namespace polhode
