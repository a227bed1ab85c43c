// SPDX-License-Identifier: Apache-2.0
// The whole of a result as one JSON document, and back. Every number reads back as the same number.
#pragma once

#include <string>
#include <string_view>

#include "reports/model/results.hpp"

namespace polhode::report {

/// One record a line, and beside the results the plots that there are of them, which from_json passes over. A number
/// that is missing, NaN or infinite is null, and the record's status or reason says why.
std::string to_json(const results&);

/// Reads a digest (digest.hpp), too, with what it holds.
/// Throws input_error, on one line, for text that is cut short, foreign, or of another schema version.
/// Keys that are not known are passed over. A null where the model has no empty value reads as NaN.
results from_json(std::string_view);

/// Whether the text begins as to_json begins it: enough to tell our files from others without reading them whole.
bool looks_like_results(std::string_view beginning);

}  // namespace polhode::report
