// SPDX-License-Identifier: Apache-2.0
// What a process is told, through one that tells it back: its states become sums of what it is handed.
#include "foreign/process.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <thread>

#include "scene/scene.hpp"

namespace polhode::foreign {
namespace {

constexpr int paths = 8, components = 3, channels = 3, pairs = 3;

/// pi1: steps times dt; pi2: all words behind the states; pi3: these times the number of their row in a frame.
constexpr auto teller = R"(import json, struct, sys
HEADER = struct.Struct('=4s5id')
print(f'{{"polhode":1,"name":"tells","takes":"{sys.argv[1]}"}}', flush=True)
while head := sys.stdin.buffer.read(HEADER.size):
    header = HEADER.unpack(head)
    begin, kind, paths, steps, noise, size, dt = header
    body = sys.stdin.buffer.read(size)
    if kind == 1: scene, states = json.loads(body), b''
    else:
        assert steps <= 4096 and size < 2**21 and 'dt' not in scene and len(scene['sigma']) == scene['channels'] == 3
        assert noise == {'increments': 1 if size > 24 * paths else 0, 'areas': 2, 'own numbers': 3}[sys.argv[1]]
        x = list(struct.unpack_from(f'={3 * paths}d', body))
        words = struct.unpack(f'={size // 8 - 3 * paths}{"Q" if noise == 3 else "d"}', body[24 * paths:])
        for p in range(paths):
            x[p] += steps * dt
            x[paths + p] += sum(words[p::paths])
            x[2 * paths + p] += sum((row + 1) * word for row, word in enumerate(words[p::paths]))
        states = struct.pack(f'={len(x)}d', *x)
    sys.stdout.buffer.write(HEADER.pack(*header[:5], len(states), dt) + states)
    sys.stdout.buffer.flush()
)";

class Process : public testing::Test {
 protected:
  Process() { std::ofstream(file_) << teller; }
  ~Process() override { std::filesystem::remove(file_); }
  std::unique_ptr<integrator> open(const std::string& takes) const {
    return open_process(fmt::format("python3 -I -S '{}' '{}'", file_.string(), takes), 60);
  }
  static problem at(double dt) { return {load_scene("paper"), components, channels, dt}; }

 private:
  std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / fmt::format("polhode-teller-{}.py", ::getpid());
};

std::vector<double> numbers(int steps, int rows) {
  std::vector<double> out(static_cast<std::size_t>(steps * rows * paths));
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = std::sin(1.0 + 2.0 * static_cast<double>(i));
  return out;
}

/// sum over steps, rows and of weight(row in the frame) * words[step][row][path]
template <class Words, class Weight>
double sum(const Words& words, int path, Weight weight) {
  double out = 0;
  for (std::size_t row = 0; row < words.size() / paths; ++row)
    out += weight(row) * static_cast<double>(words[row * paths + static_cast<std::size_t>(path)]);
  return out;
}

constexpr auto one = [](std::size_t) { return 1.0; };

void expect_states(const std::vector<double>& states, int component, int path, double expected) {
  EXPECT_NEAR(states[static_cast<std::size_t>(component * paths + path)], expected, 1e-10 * (1 + std::fabs(expected)));
}

TEST_F(Process, IsHandedLongBatchesInFramesOfAFewSteps) {
  const auto tells = open("increments");
  for (const int steps : {10000, 1}) {
    const auto dw = numbers(steps, channels);
    std::vector<double> states(components * paths, 0.5);
    tells->open(at(0.25))->advance({paths, steps, states.data(), dw.data(), nullptr, nullptr});
    tells->open(at(0.5))->advance({paths, steps, states.data(), nullptr, nullptr, nullptr});
    for (int p = 0; p < paths; ++p) {
      expect_states(states, 0, p, 0.5 + 0.75 * steps);
      expect_states(states, 1, p, 0.5 + sum(dw, p, one));
    }
  }
}

TEST_F(Process, IsHandedAreasBehindIncrements) {
  constexpr int steps = 5;
  const auto dw = numbers(steps, channels), area = numbers(2 * steps, pairs);  // others than dw from the middle on
  const double* areas = area.data() + steps * pairs * paths;
  std::vector<double> states(components * paths), all(dw);
  all.insert(all.end(), areas, areas + steps * pairs * paths);
  open("areas")->open(at(0.25))->advance({paths, steps, states.data(), dw.data(), areas, nullptr});
  for (int p = 0; p < paths; ++p)
    expect_states(states, 2, p, sum(all, p, [](std::size_t row) { return 1.0 + static_cast<double>(row); }));
}

TEST_F(Process, IsHandedSeeds) {
  constexpr int steps = 5;
  std::vector<std::uint64_t> seeds(steps * paths);
  for (std::size_t i = 0; i < seeds.size(); ++i) seeds[i] = (1 + i) * 0x1000000000001u;  // more than 32 bits
  std::vector<double> states(components * paths);
  open("own numbers")->open(at(0.25))->advance({paths, steps, states.data(), nullptr, nullptr, seeds.data()});
  for (int p = 0; p < paths; ++p) expect_states(states, 1, p, sum(seeds, p, one));
}

TEST_F(Process, ServesThreadsAtATime) {
  const auto tells = open("increments");
  std::vector<std::vector<double>> states(4, std::vector<double>(components * paths));
  {
    std::vector<std::jthread> all;
    for (std::size_t t = 0; t < states.size(); ++t)
      all.emplace_back([&, t] {
        const auto mine = tells->open(at(0.25 * static_cast<double>(t + 1)));
        for (int i = 0; i < 50; ++i) mine->advance({paths, 2, states[t].data(), nullptr, nullptr, nullptr});
      });
  }
  for (std::size_t t = 0; t < states.size(); ++t) expect_states(states[t], 0, 0, 25.0 * static_cast<double>(t + 1));
}

}  // namespace
}  // namespace polhode::foreign
