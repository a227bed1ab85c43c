// SPDX-License-Identifier: Apache-2.0
// The schemes whose kernels for the rigid body are compiled in a source of their own. One that is in no party is
// compiled with the binding itself.
#pragma once

#define POLHODE_MEETS_RIGID_BODY(scheme) template void add_scheme<scheme>(subject&, const rigid_body&);
#define POLHODE_SPLITTINGS(apply) apply(lie_trotter) apply(strang) apply(strang_two_turns) apply(strang_weak2)
#define POLHODE_ROTATIONS(apply) \
  apply(implicit_midpoint) apply(lie_euler) apply(lie_heun) apply(cayley_heun) apply(magnus)
