// SPDX-License-Identifier: Apache-2.0
// Instruction sets for which the inner loops are compiled, chosen when the program starts.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace polhode {

/// x86-64 levels (v2: SSE4.2, v3: AVX2 and FMA, v4: AVX-512); portable: whatever the compiler's default gives.
enum class isa { portable, v2, v3, v4 };

std::string_view name_of(isa);
std::optional<isa> isa_named(std::string_view name);

/// Those that this build has and this processor can run, widest last. Never empty.
std::span<const isa> usable_isas();

/// The one in force: the widest, or the one that was chosen. Choose before any work; throws std::invalid_argument for
/// one that is not usable here.
isa active_isa();
void choose_isa(isa);

/// The widest set, up to the given one, whose loops with AES instructions this processor can run: v4 asks for them on
/// 512 bits, v2 and v3 on 128. A portable build has them where the compiler's target does.
std::optional<isa> aes_isa(isa widest);

}  // namespace polhode
