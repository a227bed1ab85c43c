#include "ensemble/shared_increments.hpp"

#include <algorithm>
#include <cmath>

#include "ensemble/noise_defect.hpp"
#include "ensemble/paths.hpp"
#include "ensemble/work_counters.hpp"

namespace polhode {
namespace {

int pairs_among(int channels) { return channels * (channels - 1) / 2; }

/// The first `wanted` of `rows` normals at the address, scaled; the others stay zero.
void draw(const noise_address& address, int wanted, double scale, noise_source source, double* out) {
  for (int k = 0; k < wanted; k += 2) {
    const auto pair = normal_pair(address, static_cast<std::uint32_t>(k / 2), source);
    out[k] = scale * pair[0];
    if (k + 1 < wanted) out[k + 1] = scale * pair[1];
  }
}

}  // namespace

shared_increments::shared_increments(const model& m, std::uint64_t seed, std::int64_t steps, double dt, bool with_areas,
                                     int threads, noise_source source, std::uint64_t path)
    : dt_(dt),
      channels_(m.channels()),
      pairs_(pairs_among(m.channels())),
      drawn_(0),
      dw_(static_cast<std::size_t>(steps * channels_)),
      area_(with_areas ? static_cast<std::size_t>(steps * pairs_) : 0) {
  constexpr std::int64_t piece = 4096;
  const int active = m.active_channels(), areas = with_areas && active > 1 ? pairs_ : 0;
  drawn_ = static_cast<std::uint64_t>(steps) * static_cast<std::uint64_t>(active + areas);
  count_normals(drawn_);
  const auto* defect = noise_defect_in_force();
  if (defect) path = defect->path(path);
  parallel_for(threads, static_cast<int>((steps + piece - 1) / piece), [&](int p) {
    for (std::int64_t i = p * piece; i < std::min(steps, (p + 1) * piece); ++i) {
      const auto step = static_cast<std::uint64_t>(i);
      draw({seed, noise_kind::increment, path, step}, active, std::sqrt(dt), source, dw_.data() + i * channels_);
      if (areas > 0) draw({seed, noise_kind::area, path, step}, areas, dt / 2, source, area_.data() + i * pairs_);
    }
  });
  if (defect) defect->spoil({path, 0, 1, static_cast<int>(steps), channels_, pairs_, dt, dw_, {}, area_});
}

increment_view shared_increments::view(std::int64_t first_step, int steps) const {
  const auto part = [&](const std::vector<double>& all, int rows) -> std::span<const double> {
    if (all.empty()) return {};
    return std::span(all).subspan(static_cast<std::size_t>(first_step * rows), static_cast<std::size_t>(steps * rows));
  };
  return {dt_, steps, part(dw_, channels_), part(area_, pairs_)};
}

double shared_increments::bytes(const model& m, std::int64_t steps, bool with_areas) {
  const int rows = m.channels() + (with_areas ? pairs_among(m.channels()) : 0);
  return static_cast<double>(steps) * rows * sizeof(double);
}

}  // namespace polhode
