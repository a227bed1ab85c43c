// SPDX-License-Identifier: Apache-2.0
#include "transfer/basis_sums.hpp"

#include "platform/isa_entry.hpp"

namespace polhode {

void add_basis(const basis_sums& request) { by_isa(POLHODE_ENTRIES(polhode_add_basis_))(request); }

}  // namespace polhode
