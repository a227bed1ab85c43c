#include "registry/rigid_body_kernels.hpp"
#include "registry/rigid_body_parties.hpp"
#include "registry/schemes.hpp"

namespace polhode {

POLHODE_SPLITTINGS(POLHODE_MEETS_RIGID_BODY)

}  // namespace polhode
