// SPDX-License-Identifier: Apache-2.0
// A picture as a PNG file: a palette, the same bytes for the same pixels.
#pragma once

#include <string>

#include "reports/writers/raster.hpp"

namespace polhode::report {

/// Throws output_error where libpng fails.
std::string to_png(const raster&);

}  // namespace polhode::report
