// SPDX-License-Identifier: Apache-2.0
// Sampling that stops when its intervals are tight.
//
// Paths come in batches whose ends are fixed in advance: `first` paths, twice that, …, `most`. At each end a scheme may
// stop, by the widths of its own intervals and by nothing else: never by where they lie, so that no verdict is
// favoured. Such fixed-width sequential intervals keep their coverage as the width falls (Chow, Robbins, Ann. Math.
// Stat. 36 (1965) 457-462); that the first batch is large keeps a width that is small by accident from counting.
// A scheme's paths are then a function of the scene, the effort and the seed: neither threads nor the other schemes of
// the run change them.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "experiments/common/experiment.hpp"

namespace polhode {

/// In paths; both are rounded up to whole blocks.
struct sampling_plan {
  int first = 0, most = 0;
};

struct sample_size {
  int used = 0, planned = 0;
  std::string text() const;  ///< "640 of 2048 planned paths were enough"
};

/// The whole blocks that hold so many paths.
int blocks_of(int paths);

/// run_block(block, open) runs one block of paths of the schemes that are still open, on any thread, each block to its
/// own place. tight(scheme, paths) is asked at the end of a batch, of different schemes on different threads; at the
/// last end as well, where its answer changes nothing.
std::vector<sample_size> sample_until_tight(const context&, const sampling_plan&, int schemes,
                                            const std::function<void(int block, std::span<const int> open)>& run_block,
                                            const std::function<bool(int scheme, int paths)>& tight);

}  // namespace polhode
