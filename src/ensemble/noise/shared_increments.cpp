// SPDX-License-Identifier: Apache-2.0
#include "ensemble/noise/shared_increments.hpp"

#include <algorithm>
#include <cmath>

#include "ensemble/noise/noise_defect.hpp"
#include "ensemble/noise/normal_block.hpp"
#include "ensemble/noise/paths.hpp"
#include "platform/work_counters.hpp"

namespace polhode {
namespace {

/// The first `wanted` of `rows` normals at the address, scaled; the others stay zero.
void draw(const noise_address& address, int wanted, double scale, noise_source source, double* out) {
  for (int k = 0; k < wanted; k += 2) {
    const auto pair = normal_pair(address, static_cast<std::uint32_t>(k / 2), source);
    out[k] = scale * pair[0];
    if (k + 1 < wanted) out[k + 1] = scale * pair[1];
  }
}

/// The first `wanted` of `rows` normals of every step of a block of paths, to to(lane)[step][row].
template <class To>
void draw_block(normal_block all, std::int64_t steps, const To& to) {
  constexpr std::int64_t piece = 32;  // steps: they stay in the nearest cache
  lane_vector<double> drawn(static_cast<std::size_t>(piece * all.rows * block_lanes));
  all.out = drawn.data();
  for (std::int64_t i = 0; i < steps; i += piece) {
    all.first_step = static_cast<std::uint64_t>(i);
    all.steps = static_cast<int>(std::min(piece, steps - i));
    fill_normals(all);
    for (int lane = 0; lane < block_lanes; ++lane) {
      double* out = to(lane) + i * all.rows;
      for (int row = 0; row < all.steps * all.rows; ++row)
        if (row % all.rows < all.wanted) out[row] = drawn[static_cast<std::size_t>(row * block_lanes + lane)];
    }
  }
}

}  // namespace

shared_increments::shared_increments(const model& m, std::int64_t steps, bool with_areas)
    : layout_(m.layout()),
      drawn_(static_cast<std::uint64_t>(steps) * static_cast<std::uint64_t>(layout_.drawn(with_areas))),
      dw_(layout_.increments(steps)),
      area_(with_areas ? layout_.areas(steps) : 0) {}

shared_increments::shared_increments(const model& m, std::uint64_t seed, std::int64_t steps, double dt, bool with_areas,
                                     int threads, noise_source source, std::uint64_t path)
    : shared_increments(m, steps, with_areas) {
  constexpr std::int64_t piece = 4096;
  const int active = layout_.active, areas = with_areas ? layout_.active_pairs() : 0;
  count_normals(drawn_);
  const auto* defect = noise_defect_in_force();
  if (defect) path = defect->path(path);
  parallel_for(threads, static_cast<int>((steps + piece - 1) / piece), [&](int p) {
    for (std::int64_t i = p * piece; i < std::min(steps, (p + 1) * piece); ++i) {
      const auto step = static_cast<std::uint64_t>(i);
      draw({seed, noise_kind::increment, path, step}, active, std::sqrt(dt), source,
           dw_.data() + layout_.increments(i));
      if (areas > 0) draw({seed, noise_kind::area, path, step}, areas, dt / 2, source, area_.data() + layout_.areas(i));
    }
  });
  if (defect) defect->spoil({path, 0, 1, static_cast<int>(steps), layout_, dt, dw_, {}, area_});
}

std::vector<shared_increments> shared_increments::of_block(const model& m, std::uint64_t seed, std::int64_t steps,
                                                           double dt, bool with_areas, noise_source source,
                                                           std::uint64_t first_path) {
  std::vector<shared_increments> out;
  if (noise_defect_in_force()) {  // which is one of a single path
    for (std::uint64_t lane = 0; lane < block_lanes; ++lane)
      out.emplace_back(m, seed, steps, dt, with_areas, 1, source, first_path + lane);
    return out;
  }
  out.assign(block_lanes, shared_increments(m, steps, with_areas));
  count_normals(block_lanes * out[0].drawn_);
  const auto draw = [&](noise_kind kind, int rows, int wanted, double scale,
                        std::vector<double> shared_increments::*to) {
    draw_block({seed, kind, first_path, 0, 0, rows, wanted, scale, nullptr, source}, steps,
               [&](int lane) { return (out[static_cast<std::size_t>(lane)].*to).data(); });
  };
  const auto layout = m.layout();
  draw(noise_kind::increment, layout.channels, layout.active, std::sqrt(dt), &shared_increments::dw_);
  if (const int pairs = layout.active_pairs(); with_areas && pairs > 0)
    draw(noise_kind::area, pairs, pairs, dt / 2, &shared_increments::area_);
  return out;
}

increment_view shared_increments::view(std::int64_t first_step, int steps) const {
  const auto part = [&](const std::vector<double>& all, int rows) -> std::span<const double> {
    if (all.empty()) return {};
    return std::span(all).subspan(static_cast<std::size_t>(first_step * rows), static_cast<std::size_t>(steps * rows));
  };
  return {steps, part(dw_, layout_.channels), part(area_, layout_.pairs())};
}

increment_view increments_side_by_side::view(std::int64_t first_step, int steps) {
  const std::size_t width = block_lanes / paths_.size();
  const auto spread = [&](std::span<const double> increment_view::*part, lane_vector<double>& out) {
    for (std::size_t path = 0; path < paths_.size(); ++path) {
      const auto one = paths_[path].view(first_step, steps).*part;
      out.resize(one.size() * block_lanes);
      for (std::size_t i = 0; i < one.size(); ++i)
        std::fill_n(out.begin() + static_cast<std::ptrdiff_t>(i * block_lanes + path * width), width, one[i]);
    }
  };
  spread(&increment_view::dw, dw_);
  spread(&increment_view::area, area_);
  return {steps, dw_, area_};
}

double shared_increments::bytes(const model& m, std::int64_t steps, bool with_areas) {
  const auto layout = m.layout();
  return static_cast<double>(steps) * (layout.channels + (with_areas ? layout.pairs() : 0)) * sizeof(double);
}

}  // namespace polhode
