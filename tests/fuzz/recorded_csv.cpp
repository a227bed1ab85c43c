// SPDX-License-Identifier: Apache-2.0
// Recorded states as text.
#include <sstream>

#include "recorded_states.hpp"
#include "reports/writers/numbers.hpp"

namespace {

using namespace polhode;

std::string written(const std::vector<fuzz::state>& states) {
  std::ostringstream out;
  out << "path,t,pi1,pi2,pi3\n";
  for (const auto& s : states) {
    out << s.path << ',' << report::shortest(s.time);
    for (const double x : s.mu) out << ',' << report::shortest(x);
    out << '\n';
  }
  return out.str();
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const recording about{"states.csv", {"pi1", "pi2", "pi3"}, {}};
  std::istringstream in{std::string(fuzz::text_of(data, size))};
  const auto states = fuzz::taken([&] { return fuzz::states_in(about, read_recorded_csv, in); });
  if (!states) return 0;
  std::istringstream again(written(*states));
  fuzz::demand(fuzz::states_in(about, read_recorded_csv, again) == *states, "states read back as the same");
  fuzz::follow(about, *states);
  return 0;
}
