// SPDX-License-Identifier: Apache-2.0
#include "experiments/lyapunov/orbit_runs.hpp"

#include <algorithm>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/judge.hpp"
#include "experiments/common/progress_counter.hpp"

namespace polhode {
namespace {

// At the longer step: at least so many, and at most. Volume and divergence agree on every path from its start on, but
// one start, as that of vortices close to each other, would outweigh what follows.
constexpr std::int64_t volume_forgetting = 64, volume_chunks = 64, most_volume_chunks = 2048;

constexpr double own_intervals = 2;  // of the equation's lambda_1: as wide may be that of the difference

increment_buffer noise_for(const context& c, bool areas) {
  return {*c.subject.model, orbit_block::chunk, areas, {c.generator, noise_quality::fast}};
}

increment_view chunk_of(const context& c, increment_buffer& noise, int block, std::int64_t chunk, double dt) {
  return noise.fill(c.seed, static_cast<std::uint64_t>(block) * block_lanes,
                    static_cast<std::uint64_t>(chunk * orbit_block::chunk), orbit_block::chunk, dt);
}

/// The first block of paths of a scheme, their start forgotten: no tangents are needed for that.
std::vector<double> forgotten_start(const context& c, const orbit_frame& f, const scheme_entry& scheme) {
  const auto stepper = scheme.make(f.dt);
  auto noise = noise_for(c, scheme.needs_areas);
  auto states = f.start.block(c.seed, 0);
  for (std::int64_t chunk = 0; chunk < volume_forgetting; ++chunk)
    stepper->advance(states, chunk_of(c, noise, 0, chunk, f.dt));
  return states;
}

/// From there on at dt / refined, its volume followed.
class volume_run {
 public:
  volume_run(const context& c, const orbit_frame& f, const scheme_entry& scheme, int refined,
             const std::vector<double>& start)
      : context_(c),
        refined_(refined),
        flow_(derivative_flow(scheme.tangent(f.dt / refined))),
        noise_(noise_for(c, scheme.needs_areas)),
        paths_(f.geometry, start, c.seed, 0, f.vectors()),
        passed_(refined * volume_forgetting) {}

  /// Growth less divergence, per time, over so many chunks of dt.
  Eigen::VectorXd defects_over(std::int64_t chunks) {
    for (const auto last = passed_ + refined_ * chunks; passed_ < last; ++passed_)
      paths_.advance(*flow_, chunk_of(context_, noise_, 0, passed_, flow_->dt()));
    const auto found = paths_.read();
    return found.volume - found.divergence;
  }

 private:
  const context& context_;
  int refined_;
  std::unique_ptr<tangent_flow> flow_;
  increment_buffer noise_;
  orbit_block paths_;
  std::int64_t passed_;
};

/// No mean comes of a lost path, however many follow: its width, which is no number, is not too wide.
bool is_wide(const Eigen::VectorXd& values, double tight) {
  const auto mean = mean_interval({values.data(), static_cast<std::size_t>(values.size())});
  return half_width(mean) > tight;
}

}  // namespace

scheme_paths::scheme_paths(const context& c, const orbit_frame& f, const std::vector<scheme_entry>& schemes,
                           const observed_rates& of_equation, int vectors, const flow_of_scheme& flow)
    : context_(c), frame_(f), of_equation_(of_equation), vectors_(vectors) {
  for (const auto& scheme : schemes) {
    auto& s = schemes_.emplace_back(sampled{flow(scheme), scheme.needs_areas, {}, {}, {}, false});
    s.rates.setZero(f.paths, vectors);
    s.blocks.resize(static_cast<std::size_t>(blocks_of(f.paths)));
  }
}

void scheme_paths::sample(double tight) {
  progress_counter done(static_cast<int>(schemes_.size()), context_.progress);
  auto inner = context_;
  inner.threads = std::max(1, context_.threads / static_cast<int>(schemes_.size()));
  inner.progress = [](double) {};
  parallel_for(context_.threads, static_cast<int>(schemes_.size()), [&](int k) {
    sample_one(schemes_[static_cast<std::size_t>(k)], inner, tight);
    done.add();
  });
}

void scheme_paths::sample_one(sampled& s, const context& c, double tight) const {
  const auto third = 2 * of_equation_.forgetting, end = of_equation_.forgetting + of_equation_.observed;
  advance(s, 0, 0, third);
  s.size = {block_lanes, blocks_of(frame_.paths) * block_lanes};
  if (is_tight(differences(s, block_lanes), tight)) return;
  s.whole = true;
  advance(s, 0, third, end);
  const auto sizes = sample_until_tight(
      c, {block_lanes, frame_.paths}, 1,
      [&](int block, std::span<const int>) {
        if (block > 0) advance(s, block, 0, end);
      },
      [&](int, int paths) { return is_tight(differences(s, paths), tight); });
  s.size = sizes.front();
}

bool scheme_paths::is_tight(const Eigen::MatrixXd& differences, double tight) const {
  for (Eigen::Index k = 0; k < differences.cols(); ++k)
    if (is_wide(differences.col(k), tight)) return false;
  const Eigen::VectorXd first = of_equation_.rates.col(0);
  return !is_wide(differences.col(0),
                  own_intervals * half_width(mean_interval({first.data(), static_cast<std::size_t>(first.size())})));
}

/// Rates are those from the end of forgetting on.
void scheme_paths::advance(sampled& s, int block, std::int64_t first_chunk, std::int64_t last_chunk) const {
  auto& paths = s.blocks[static_cast<std::size_t>(block)];
  if (!paths)
    paths.emplace(frame_.geometry, frame_.start, context_.seed, static_cast<std::uint64_t>(block) * block_lanes,
                  vectors_, false);
  auto noise = noise_for(context_, s.areas);
  for (auto i = first_chunk; i < last_chunk; ++i) {
    if (i == of_equation_.forgetting) paths->read();
    paths->advance(*s.flow, chunk_of(context_, noise, block, i, frame_.dt));
  }
  auto rates = s.rates.middleRows(static_cast<Eigen::Index>(block) * block_lanes, block_lanes);
  const auto found = paths->read().rates;
  const auto seen = static_cast<double>(std::max(first_chunk - of_equation_.forgetting, std::int64_t{0})),
             more = static_cast<double>(last_chunk - of_equation_.forgetting) - seen;
  rates = ((seen * rates + more * found) / (seen + more)).eval();
}

Eigen::MatrixXd scheme_paths::differences(const sampled& s, int paths) const {
  const auto& equation = s.whole ? of_equation_.rates : of_equation_.first_third;
  return s.rates.topRows(paths) - equation.topLeftCorner(paths, vectors_);
}

Eigen::MatrixXd scheme_paths::differences(std::size_t scheme) const {
  return differences(schemes_[scheme], schemes_[scheme].size.used);
}

Eigen::MatrixXd scheme_paths::rates(std::size_t scheme) const {
  return schemes_[scheme].rates.topRows(schemes_[scheme].size.used);
}

std::span<const double> scheme_paths::last_states(std::size_t scheme) const {
  return schemes_[scheme].blocks.front()->states();
}

std::int64_t scheme_paths::steps(std::size_t scheme) const {
  const auto observed = schemes_[scheme].whole ? of_equation_.observed : of_equation_.forgetting;
  return (of_equation_.forgetting + observed) * orbit_block::chunk;
}

std::string scheme_paths::text(std::size_t scheme) const {
  const auto& s = schemes_[scheme];
  if (!rates(scheme).allFinite()) return std::to_string(s.size.used) + " paths, not all of which came to an end";
  return s.size.text() + (s.whole ? "" : ", over a third of the planned time");
}

Eigen::VectorXd volume_defects(const context& c, const orbit_frame& f, const scheme_entry& scheme, double tight) {
  const auto start = forgotten_start(c, f, scheme);
  volume_run coarse(c, f, scheme, 1, start), fine(c, f, scheme, 2, start);
  const auto over = [&](std::int64_t chunks) -> Eigen::VectorXd {
    return 2 * fine.defects_over(chunks) - coarse.defects_over(chunks);
  };
  Eigen::VectorXd out = over(volume_chunks);
  for (auto chunks = volume_chunks; chunks < most_volume_chunks && is_wide(out, tight); chunks *= 2)
    out = ((out + over(chunks)) / 2).eval();
  return out;
}

}  // namespace polhode
