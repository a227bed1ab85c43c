// SPDX-License-Identifier: Apache-2.0
// What the commands answer, each as one JSON document: `--format json` prints it, and Python reads it.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "run/check.hpp"
#include "run/choose.hpp"
#include "run/reference.hpp"
#include "run/verify.hpp"

namespace polhode::cli {

std::string to_json(const reference_answer&);
std::string to_json(const selection&);
/// Its verdicts, and the parameters that the data follow.
std::string to_json(const checked_recording&);
/// Without a last line break.
std::string to_json(std::string_view scene, std::span<const expected_cost>, int threads);

}  // namespace polhode::cli
