// SPDX-License-Identifier: Apache-2.0
// Who is told how far a run is.
#pragma once

#include <functional>
#include <string_view>

namespace polhode {

/// Called from the working threads, never concurrently: the share done in [0, 1] and what is being worked on.
using progress_sink = std::function<void(double share, std::string_view what)>;

}  // namespace polhode
