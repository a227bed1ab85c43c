// SPDX-License-Identifier: Apache-2.0
#include "ensemble/noise/normal_block.hpp"

#include <stdexcept>

#include "platform/cpu_profile.hpp"
#include "platform/isa_entry.hpp"

namespace polhode {

bool ars_usable() { return aes_isa(active_isa()).has_value(); }

void fill_normals(const normal_block& request) {
  working_on("noise");
  if (request.singles != nullptr && request.source.quality == noise_quality::precise)
    throw std::invalid_argument("noise quality precise: not to be had in single precision; accepted: fast");
  if (request.source.generator == noise_generator::philox)
    return by_isa(POLHODE_ENTRIES(polhode_fill_normals_))(request);
  const auto level = aes_isa(active_isa());
  if (!level)
    throw std::invalid_argument(
        "noise generator ars: no AES instructions in this processor or build; accepted: philox");
  for_isa(*level, POLHODE_ALL_ENTRIES(polhode_fill_normals_ars_))(request);
}

}  // namespace polhode
