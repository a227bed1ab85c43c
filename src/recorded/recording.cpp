// SPDX-License-Identifier: Apache-2.0
#include "recorded/recording.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <system_error>

#include "recorded/recording_kinds.hpp"
#include "reports/model/errors.hpp"
#include "reports/model/text.hpp"

namespace polhode {
namespace {

constexpr int npy_mark = 0x93;

}  // namespace

std::string place_of(const recording& r, std::uint64_t place) {
  return fmt::format("{}: {} {}", one_line(r.file.string()), r.dt ? "state" : "line", place);
}

recording_size read_recording(const recording& r, const state_sink& take) {
  const auto name = one_line(r.file.string());
  if (std::error_code none; std::filesystem::is_directory(r.file, none))
    throw input_error(fmt::format("{}: a folder; accepted: recorded data, .csv or .npy", name));
  std::ifstream in(r.file, std::ios::binary);
  if (!in) throw input_error(fmt::format("{}: {}", name, std::generic_category().message(errno)));
  const bool array = in.peek() == npy_mark;
  if (array && !r.dt)
    throw input_error(fmt::format("{}: an array has no times; accepted: --dt, the time from state to state", name));
  if (!array && r.dt) throw input_error(fmt::format("{}: has times of its own; accepted: --dt with .npy", name));
  const auto size = array ? read_recorded_npy(r, in, take) : read_recorded_csv(r, in, take);
  if (in.bad()) throw input_error(fmt::format("{}: {}", name, std::generic_category().message(errno)));
  if (size.states == 0) throw input_error(fmt::format("{}: no states; accepted: two of a path, or more", name));
  return size;
}

}  // namespace polhode
