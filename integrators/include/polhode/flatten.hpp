// SPDX-License-Identifier: Apache-2.0
// POLHODE_FLATTEN: all that a function calls is inlined into it, so that numbers and packs stay in registers. Not under
// sanitizers, where it would repeat their checks at every place of every call: hours of compiling; nor where a build
// defines it as nothing, to count lines.
#pragma once

#if defined(POLHODE_FLATTEN)
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define POLHODE_FLATTEN
#else
#define POLHODE_FLATTEN [[gnu::flatten]]
#endif
