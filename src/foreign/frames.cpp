// SPDX-License-Identifier: Apache-2.0
#include "foreign/frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include <polhode/increment.hpp>

#include "reports/model/text.hpp"

namespace polhode::foreign {
namespace {

enum frame_kind : std::int32_t { scene_frame = 1, steps_frame = 2 };
enum noise_kind : std::int32_t { no_noise, increments, increments_and_areas, seeds };

constexpr std::array<char, 4> magic{'P', 'O', 'L', 'H'};
constexpr std::size_t longest_text = 1 << 16;  // bytes of a greeting, or of a reason
constexpr std::size_t most_noise = 1 << 20;    // bytes of a frame
constexpr int most_steps = 4096;               // of a frame

struct header {
  std::array<char, 4> begin = magic;
  std::int32_t kind = 0, paths = 0, steps = 0, noise = 0, bytes = 0;
  double dt = 0;
};
static_assert(sizeof(header) == 32);

std::string text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The header of an answer, which `got` bytes of have come: what follows them is up to the caller.
header hear_header(dialogue& with, std::span<std::byte> answer, std::size_t& got, frame_kind kind) {
  header h;
  for (got = 0; got < sizeof h;) {
    got = with.hear(answer, got, got + 1);
    if (std::memcmp(answer.data(), magic.data(), std::min(got, magic.size())) != 0)
      with.fail(fmt::format("wrote '{}' where a frame was expected",
                            one_line(text_of(answer.first(std::min<std::size_t>(got, 256))) + with.overheard(), 60)));
  }
  std::memcpy(&h, answer.data(), sizeof h);
  if (h.kind != kind)
    with.fail(fmt::format("answered with a frame of kind {} to one of kind {}", h.kind, static_cast<int>(kind)));
  if (!with.said_all()) with.fail("answered before it had read the whole frame");
  return h;
}

iovec part(const void* from, std::size_t bytes) { return {const_cast<void*>(from), bytes}; }

struct noise_part {
  const void* from = nullptr;
  std::size_t bytes_a_step = 0;
  iovec of(int first, int steps) const {
    return part(static_cast<const char*>(from) + static_cast<std::size_t>(first) * bytes_a_step,
                static_cast<std::size_t>(steps) * bytes_a_step);
  }
};

/// What a batch holds beside its states, by step.
struct told_noise {
  noise_kind kind = no_noise;
  std::array<noise_part, 2> parts{};

  told_noise(const problem& p, const batch& b) {
    const auto row = static_cast<std::size_t>(b.paths) * sizeof(double);
    if (b.seed != nullptr) {
      kind = seeds;
      parts[0] = {b.seed, row};
    } else if (b.dw != nullptr) {
      kind = b.area != nullptr ? increments_and_areas : increments;
      parts[0] = {b.dw, row * static_cast<std::size_t>(p.channels)};
      if (b.area != nullptr) parts[1] = {b.area, row * static_cast<std::size_t>(pairs_among(p.channels))};
    }
  }
  std::size_t bytes_a_step() const { return parts[0].bytes_a_step + parts[1].bytes_a_step; }
  int steps_of_a_frame() const {
    return static_cast<int>(
        std::clamp<std::size_t>(most_noise / std::max<std::size_t>(bytes_a_step(), 1), 1, most_steps));
  }
};

void hear_states(dialogue& with, const header& asked, std::span<std::byte> states) {
  thread_local std::vector<std::byte> answer;
  answer.resize(sizeof(header) + states.size());
  std::size_t got = 0;
  const auto h = hear_header(with, answer, got, steps_frame);
  if (h.paths != asked.paths) with.fail(fmt::format("answered {} paths of {}", h.paths, asked.paths));
  if (h.bytes < 0 || static_cast<std::size_t>(h.bytes) != states.size())
    with.fail(fmt::format("answered {} bytes of states instead of {}", h.bytes, states.size()));
  if (got < answer.size()) with.hear(answer, got, answer.size());
  std::memcpy(states.data(), answer.data() + sizeof h, states.size());
}

}  // namespace

std::string hear_greeting(dialogue& with) {
  std::vector<std::byte> line(longest_text);
  for (std::size_t got = 0; got < line.size();) {
    got = with.hear(line, got, got + 1);
    const auto text = text_of(std::span(line).first(got));
    const auto end = text.find('\n');
    if (end == std::string::npos) continue;
    if (end + 1 < got)
      with.fail(fmt::format("wrote '{}' behind its greeting of one line", one_line(text.substr(end + 1), 60)));
    return text.substr(0, end);
  }
  with.fail(fmt::format("wrote {} bytes without the end of a line: a greeting is one line", longest_text));
}

void tell_scene(dialogue& with, const std::string& json) {
  const header asked{.kind = scene_frame, .bytes = static_cast<std::int32_t>(json.size())};
  const std::array parts{part(&asked, sizeof asked), part(json.data(), json.size())};
  with.say(parts);
  std::vector<std::byte> answer(sizeof(header));
  std::size_t got = 0;
  const auto h = hear_header(with, answer, got, scene_frame);
  if (h.bytes == 0) return;
  if (h.bytes < 0 || static_cast<std::size_t>(h.bytes) > longest_text)
    with.fail(fmt::format("answered to a scene with {} bytes: accepted: none, or a reason of up to {}", h.bytes,
                          longest_text));
  std::vector<std::byte> why(static_cast<std::size_t>(h.bytes));
  with.hear(why, 0, why.size());
  throw refusal("refused the scene: " + one_line(text_of(why), 240));
}

void ask_for_steps(dialogue& with, const problem& p, const batch& b) {
  const told_noise noise(p, b);
  const auto states = std::as_writable_bytes(std::span(b.states, static_cast<std::size_t>(p.components * b.paths)));
  const int most = noise.steps_of_a_frame();
  for (int done = 0; done < b.steps; done += most) {
    const int now = std::min(most, b.steps - done);
    const std::array parts{part(states.data(), states.size()), noise.parts[0].of(done, now),
                           noise.parts[1].of(done, now)};
    header asked{.kind = steps_frame, .paths = b.paths, .steps = now, .noise = noise.kind, .dt = p.dt};
    for (const auto& one : parts) asked.bytes += static_cast<std::int32_t>(one.iov_len);
    const std::array frame{part(&asked, sizeof asked), parts[0], parts[1], parts[2]};
    with.say(frame);
    hear_states(with, asked, states);
  }
}

}  // namespace polhode::foreign
