// SPDX-License-Identifier: Apache-2.0
// Recorded states as an array.
#include <sstream>

#include "recorded_states.hpp"
#include "reports/writers/npy.hpp"

namespace {

using namespace polhode;

std::string written(const std::vector<fuzz::state>& states) {
  const auto paths = static_cast<std::size_t>(states.back().path) + 1;
  auto out = report::npy_header_of_doubles({paths, states.size() / paths, states.back().mu.size()});
  for (const auto& s : states) out.append(reinterpret_cast<const char*>(s.mu.data()), s.mu.size() * sizeof(double));
  return out;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const recording about{"states.npy", {"pi1", "pi2", "pi3"}, 0.25};
  std::istringstream in{std::string(fuzz::text_of(data, size))};
  const auto states = fuzz::taken([&] { return fuzz::states_in(about, read_recorded_npy, in); });
  if (!states || states->empty()) return 0;
  std::istringstream again(written(*states));
  fuzz::demand(fuzz::states_in(about, read_recorded_npy, again) == *states, "states read back as the same");
  fuzz::follow(about, *states);
  return 0;
}
