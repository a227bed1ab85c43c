#include "experiments/lyapunov/orbit_runs.hpp"

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"

namespace polhode {
namespace {

constexpr std::int64_t volume_chunks = 256, volume_forgetting = 64;  // at the longer step

increment_buffer noise_for(const context& c, bool areas) {
  return {*c.subject.model, orbit_block::chunk, areas, {c.generator, noise_quality::fast}};
}

increment_view chunk_of(const context& c, increment_buffer& noise, int block, std::int64_t chunk, double dt) {
  return noise.fill(c.seed, static_cast<std::uint64_t>(block) * block_lanes,
                    static_cast<std::uint64_t>(chunk * orbit_block::chunk), orbit_block::chunk, dt);
}

/// At dt / refined, of the first block of paths.
Eigen::VectorXd volume_defects_at(const context& c, const orbit_frame& f, const scheme_entry& scheme, int refined) {
  const double dt = f.dt / refined;
  const auto flow = derivative_flow(scheme.tangent(dt));
  auto noise = noise_for(c, scheme.needs_areas);
  orbit_block paths(f.geometry, f.start, c.seed, 0, f.vectors());
  for (std::int64_t i = 0; i < refined * (volume_forgetting + volume_chunks); ++i) {
    if (i == refined * volume_forgetting) paths.read();
    paths.advance(*flow, chunk_of(c, noise, 0, i, dt));
  }
  const auto found = paths.read();
  return found.volume - found.divergence;
}

}  // namespace

scheme_paths::scheme_paths(const context& c, const orbit_frame& f, const std::vector<scheme_entry>& schemes,
                           const observed_rates& of_equation, int vectors, const flow_of_scheme& flow)
    : context_(c),
      frame_(f),
      schemes_(schemes),
      of_equation_(of_equation),
      vectors_(vectors),
      found_(schemes.size(), observed_rates(f.paths, vectors)),
      last_states_(schemes.size()) {
  for (const auto& scheme : schemes) flows_.push_back(flow(scheme));
}

void scheme_paths::sample(double tight) {
  sizes_ = sample_until_tight(
      context_, {block_lanes, frame_.paths}, static_cast<int>(schemes_.size()),
      [&](int block, std::span<const int> open) { run(block, open); },
      [&](int scheme, int paths) {
        const auto all = differences(static_cast<std::size_t>(scheme), paths);
        for (Eigen::Index k = 0; k < all.cols(); ++k)
          if (!(half_width(mean_interval({all.col(k).data(), static_cast<std::size_t>(paths)})) <= tight)) return false;
        return true;
      });
}

Eigen::MatrixXd scheme_paths::differences(std::size_t scheme, int paths) const {
  return found_[scheme].rates.topRows(paths) - of_equation_.rates.topLeftCorner(paths, vectors_);
}

void scheme_paths::run(int block, std::span<const int> open) {
  bool areas = false;
  std::vector<orbit_block> blocks;
  for (const int k : open) {
    areas = areas || schemes_[static_cast<std::size_t>(k)].needs_areas;
    blocks.emplace_back(frame_.geometry, frame_.start, context_.seed, static_cast<std::uint64_t>(block) * block_lanes,
                        vectors_, false);
  }
  auto noise = noise_for(context_, areas);
  for (std::int64_t i = 0; i < of_equation_.forgetting + of_equation_.observed; ++i) {
    const auto view = chunk_of(context_, noise, block, i, frame_.dt);
    for (std::size_t k = 0; k < open.size(); ++k) {
      if (i == of_equation_.forgetting) blocks[k].read();
      blocks[k].advance(*flows_[static_cast<std::size_t>(open[k])], view);
    }
  }
  for (std::size_t k = 0; k < open.size(); ++k) {
    const auto scheme = static_cast<std::size_t>(open[k]);
    found_[scheme].keep(block, blocks[k].read());
    if (block == 0) last_states_[scheme].assign(blocks[k].states().begin(), blocks[k].states().end());
  }
}

Eigen::VectorXd volume_defects(const context& c, const orbit_frame& f, const scheme_entry& scheme) {
  return 2 * volume_defects_at(c, f, scheme, 2) - volume_defects_at(c, f, scheme, 1);
}

}  // namespace polhode
