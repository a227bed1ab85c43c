// SPDX-License-Identifier: Apache-2.0
// Texts that a page carries, made short.
#pragma once

#include <string>
#include <string_view>

namespace polhode::report {

/// Compressed by zlib (RFC 1950) and written in base64 (RFC 4648): a seventh of results.json, free of markup, and the
/// same for the same text. Empty for an empty text.
std::string packed(std::string_view text);

}  // namespace polhode::report
