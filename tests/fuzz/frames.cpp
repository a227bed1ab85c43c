// SPDX-License-Identifier: Apache-2.0
// The frames with which a process answers to a scene and to steps. The first two bytes say what it is asked and how
// many bytes it writes on its standard error stream; these come next, and behind them the frames.
#include "foreign/frames.hpp"

#include <algorithm>
#include <vector>

#include "fuzz.hpp"

namespace {

using namespace polhode;

constexpr int components = 3, channels = 3, pairs = 3, most_paths = 8, most_steps = 5000;  // more than of one frame

struct questions {
  foreign::problem problem{{}, components, channels, 0.25};
  std::vector<double> states, noise = std::vector<double>(most_steps * pairs * most_paths);
  std::vector<std::uint64_t> seeds = std::vector<std::uint64_t>(most_steps * most_paths);

  /// paths from bits 0 to 2, noise from 3 and 4, one step or many from 5.
  foreign::batch asked(unsigned bits) {
    foreign::batch b{.paths = 1 + static_cast<int>(bits % most_paths), .steps = (bits & 32U) != 0 ? most_steps : 1};
    const auto kind = bits / 8 % 4;
    states.assign(static_cast<std::size_t>(components * b.paths), 1.0);
    b.states = states.data();
    if (kind == 1 || kind == 2) b.dw = noise.data();
    if (kind == 2) b.area = noise.data();
    if (kind == 3) b.seed = seeds.data();
    return b;
  }
};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static questions all;
  if (size < 2) return 0;
  const std::string text(fuzz::text_of(data + 2, size - 2));
  const auto complaints = std::min<std::size_t>(data[1], text.size());
  foreign::dialogue with({text.substr(complaints), text.substr(0, complaints)}, 5);
  fuzz::taken<foreign::failure>([&] {
    foreign::tell_scene(with, "{}");
    foreign::ask_for_steps(with, all.problem, all.asked(data[0]));
    return true;
  });
  return 0;
}
