// SPDX-License-Identifier: Apache-2.0
// The two kinds of file that recordings come in.
#pragma once

#include <istream>

#include "recorded/recording.hpp"

namespace polhode {

recording_size read_recorded_csv(const recording&, std::istream&, const state_sink&);
recording_size read_recorded_npy(const recording&, std::istream&, const state_sink&);

}  // namespace polhode
