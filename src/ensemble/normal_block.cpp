#include "ensemble/normal_block.hpp"

#include "ensemble/isa_entry.hpp"

namespace polhode {

void fill_normals(const normal_block& request) { by_isa(POLHODE_ENTRIES(polhode_fill_normals_))(request); }

}  // namespace polhode
