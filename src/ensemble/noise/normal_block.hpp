// SPDX-License-Identifier: Apache-2.0
// Normals for a block of paths, compiled once per instruction set; the values do not depend on which one runs.
#pragma once

#include <cstdint>

#include <polhode/noise/address.hpp>

#include "platform/isa_entry.hpp"

namespace polhode {

/// `wanted` of `rows` normals (channels), times `scale`, for every lane of a block and every step: out is
/// [step][row][lane]. Rows that are not wanted are left alone. Where `singles` is given it takes, in place of `out`,
/// the normals as they are, before `scale`: half the memory traffic for whoever multiplies by `scale` in double
/// precision himself. Fast normals only.
struct normal_block {
  std::uint64_t seed;
  noise_kind kind;
  std::uint64_t first_path, first_step;
  int steps, rows, wanted;
  double scale;
  double* out;
  noise_source source{};
  float* singles = nullptr;
};

/// Can this build and processor run ARS? It needs AES instructions.
bool ars_usable();

/// By the instruction set in force. Throws std::invalid_argument for ARS where it is not usable, and for precise
/// singles.
void fill_normals(const normal_block&);

}  // namespace polhode

POLHODE_DECLARE_ENTRIES(polhode_fill_normals_ars_, const polhode::normal_block&);
POLHODE_DECLARE_ENTRIES(polhode_fill_normals_, const polhode::normal_block&);
