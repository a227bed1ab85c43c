// SPDX-License-Identifier: Apache-2.0
// POLHODE_CALLED: a function of packs of some length that loops call and do not inline, as they would be compiled a
// dozen times over; all that it calls is inlined into it, so that packs stay in registers. That not under sanitizers,
// where it would repeat their checks at every place of every call: hours of compiling.
#pragma once

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define POLHODE_CALLED [[gnu::noinline]]
#else
#define POLHODE_CALLED [[gnu::noinline, gnu::flatten]]
#endif
