// SPDX-License-Identifier: Apache-2.0
#include "ensemble/ensemble_progress.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <type_traits>

namespace polhode {
namespace {

/// The same order of fields for both directions: `pass` writes or reads one.
template <class Progress, class Pass>
void pass_all(Progress& p, const Pass& pass) {
  pass(p.states);
  for (auto& one : p.pieces) {
    pass(one.block);
    pass(one.step);
    pass(one.states);
    for (auto& m : one.moments) {
      pass(m.energy);
      pass(m.components);
      pass(m.lost);
      pass(m.casimir_change);
    }
  }
  for (auto& s : p.snapshots) {
    pass(s.counts);
    pass(s.picture);
  }
}

struct writer {
  const byte_sink& sink;
  template <class T>
  void operator()(const T& x) const {
    static_assert(std::is_trivially_copyable_v<T>);
    sink(&x, sizeof x);
  }
  template <class T>
  void operator()(const std::vector<T>& all) const {
    (*this)(all.size());
    sink(all.data(), all.size() * sizeof(T));
  }
};

struct reader {
  const byte_source& source;
  std::size_t most_states;  ///< of one block
  template <class T>
  void operator()(T& x) const {
    static_assert(std::is_trivially_copyable_v<T>);
    source(&x, sizeof x);
  }
  template <class T>
  void operator()(std::vector<T>& all) const {
    std::size_t size = 0;
    (*this)(size);
    // A block that has begun has states; all else has its size already.
    if (size != all.size() && !(all.empty() && size == most_states)) throw std::runtime_error("of another ensemble");
    all.resize(size);
    source(all.data(), size * sizeof(T));
  }
};

void add(const std::vector<std::uint32_t>& more, std::vector<std::uint32_t>& sum) {
  std::ranges::transform(sum, more, sum.begin(), std::plus<>());
}

}  // namespace

std::int64_t ensemble_progress::blocks_of(std::size_t piece) const {
  const auto all = (bodies + block_lanes - 1) / block_lanes;
  return std::min(blocks_a_piece, all - static_cast<std::int64_t>(piece) * blocks_a_piece);
}

double ensemble_progress::steps_done(std::int64_t steps_of_a_block) const {
  double sum = 0;
  for (const auto& p : pieces)
    sum += static_cast<double>(p.block) * static_cast<double>(steps_of_a_block) + static_cast<double>(p.step);
  return sum;
}

void ensemble_progress::join(const ensemble_progress& other) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& theirs = other.pieces[i];
    if (theirs.block == 0 && theirs.step == 0) continue;
    pieces[i] = theirs;
    const auto first = static_cast<std::int64_t>(i) * blocks_a_piece * block_lanes;
    const auto count = std::min(blocks_of(i) * block_lanes, bodies - first);
    for (auto row = first; row < static_cast<std::int64_t>(states.size()); row += bodies)
      std::copy_n(other.states.begin() + row, count, states.begin() + row);
  }
  for (std::size_t s = 0; s < snapshots.size(); ++s) {
    add(other.snapshots[s].counts, snapshots[s].counts);
    add(other.snapshots[s].picture, snapshots[s].picture);
  }
}

void ensemble_progress::write(const byte_sink& sink) const { pass_all(*this, writer{sink}); }

void ensemble_progress::read(const byte_source& source) {
  const auto components = pieces.empty() ? 0 : pieces.front().moments.front().components.size();
  pass_all(*this, reader{source, components * block_lanes});
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (pieces[i].block < 0 || pieces[i].block > blocks_of(i) || pieces[i].step < 0)
      throw std::runtime_error("of another ensemble");
}

}  // namespace polhode
