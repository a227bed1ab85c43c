// SPDX-License-Identifier: Apache-2.0
// Memory of packs.
#pragma once

#include <boost/align/aligned_allocator.hpp>
#include <vector>

namespace polhode {

inline constexpr std::size_t cache_line = 64;

/// [row][lane], from the start of a cache line on: no pack straddles two.
template <class T>
using lane_vector = std::vector<T, boost::alignment::aligned_allocator<T, cache_line>>;

}  // namespace polhode
