// SPDX-License-Identifier: Apache-2.0
#include "experiments/common/sequential.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "ensemble/noise/paths.hpp"
#include "experiments/common/progress_counter.hpp"

namespace polhode {

std::string sample_size::text() const {
  return used < planned ? fmt::format("{} of {} planned paths were enough", used, planned)
                        : fmt::format("all {} planned paths", planned);
}

int blocks_of(int paths) { return (paths + block_lanes - 1) / block_lanes; }

std::vector<sample_size> sample_until_tight(const context& c, const sampling_plan& plan, int schemes,
                                            const std::function<void(int block, std::span<const int> open)>& run_block,
                                            const std::function<bool(int scheme, int paths)>& tight) {
  const int most = blocks_of(plan.most);
  std::vector<sample_size> sizes(static_cast<std::size_t>(schemes), {0, most * block_lanes});
  std::vector<int> open(sizes.size());
  std::iota(open.begin(), open.end(), 0);
  progress_counter done(most, c.progress);
  int begin = 0;
  for (int batch = plan.first; begin < most && !open.empty(); batch *= 2) {
    const int end = std::min(blocks_of(batch), most);
    parallel_for(c.threads, end - begin, [&](int i) {
      run_block(begin + i, open);
      done.add();
    });
    std::vector<char> closed(sizes.size());
    parallel_for(c.threads, static_cast<int>(open.size()), [&](int i) {
      const int scheme = open[static_cast<std::size_t>(i)], paths = end * block_lanes;
      sizes[static_cast<std::size_t>(scheme)].used = paths;
      closed[static_cast<std::size_t>(scheme)] = tight(scheme, paths);
    });
    std::erase_if(open, [&](int scheme) { return closed[static_cast<std::size_t>(scheme)]; });
    begin = end;
  }
  return sizes;
}

}  // namespace polhode
