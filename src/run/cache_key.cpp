// SPDX-License-Identifier: Apache-2.0
#include "run/cache_key.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gnu/libc-version.h>
#include <gsl/gsl_version.h>

#include <array>
#include <boost/crc.hpp>
#include <fstream>

#include "platform/isa.hpp"
#include "run/provenance.hpp"

namespace polhode {
namespace {

using crc64 = boost::crc_optimal<64, 0x42F0E1EBA9EA3693, ~0ULL, ~0ULL, true, true>;

/// Size and CRC-64 of the program that runs: a build that differs in anything differs here. Empty if it cannot be read.
std::string checksum_of_program() {
  std::ifstream program("/proc/self/exe", std::ios::binary);
  std::array<char, 1 << 16> piece;
  crc64 crc;
  std::size_t size = 0;
  while (program.read(piece.data(), piece.size()), program.gcount() > 0) {
    const auto count = static_cast<std::size_t>(program.gcount());
    crc.process_bytes(piece.data(), count);
    size += count;
  }
  return program.bad() || size == 0 ? "" : fmt::format("{} bytes, CRC-64 {:016x}", size, crc.checksum());
}

/// The build, the libraries that it loads and the processor: a library may choose its code by the processor.
const std::string& build_identity() {
  static const std::string identity = [] {
    auto program = checksum_of_program();
    if (program.empty()) return program;
    const auto b = build_provenance();
    return fmt::format("version {}\ncommit {}\ncompiler {}\nflags {}\nprogram {}\nlibraries glibc {}, gsl {}\ncpu {}\n",
                       b.version, b.commit, b.compiler, b.flags, program, gnu_get_libc_version(), gsl_version, b.cpu);
  }();
  return identity;
}

/// Numbers as the shortest text that reads back as the same number.
std::string text_of(const report::scene& s) {
  std::string parameters;
  for (const auto& p : s.parameters) parameters += fmt::format("{} {}{}\n", p.name, p.rows, p.word);
  return fmt::format("system {}\n{}momentum {}\nhorizon {}\nsteps {}\n", s.system, parameters, s.momentum, s.horizon,
                     s.steps);
}

}  // namespace

std::string cache_key(const context& c, std::string_view experiment, std::string_view scheme) {
  if (build_identity().empty()) return "";
  return fmt::format("experiment {}\nscheme {}\neffort {}\nseed {}\ngenerator {}\nisa {}\n{}{}", experiment, scheme,
                     by_effort(c.effort, "quick", "standard", "thorough"), c.seed,
                     c.generator == noise_generator::ars ? "ars" : "philox", name_of(active_isa()),
                     text_of(c.subject.scene), build_identity());
}

std::string simulation_key(const scene& s, std::string_view scheme, double dt, const simulation_plan& p) {
  if (build_identity().empty()) return "";
  return fmt::format(
      "simulation\nscheme {}\ndt {}\nnoise {}\nstart {}\nbodies {}\nsnapshots {}\nstates {}\nseed {}\ngenerator {}\n"
      "normals {}\nrank {} of {}\nisa {}\n{}{}",
      scheme, dt, static_cast<int>(p.noise), static_cast<int>(p.start), p.bodies, p.snapshots, p.keep_states, p.seed,
      static_cast<int>(p.source.generator), static_cast<int>(p.source.quality), p.rank, p.ranks, name_of(active_isa()),
      text_of(s), build_identity());
}

}  // namespace polhode
