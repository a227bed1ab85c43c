// SPDX-License-Identifier: Apache-2.0
// A picture of pixels to draw into, in at most 256 colours.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace polhode::report {

using colour = std::array<std::uint8_t, 3>;
using shade = std::uint8_t;  ///< a place in the palette

struct raster {
  int width, height;
  std::vector<colour> palette;
  std::vector<shade> pixels;  ///< rows from the top

  /// All in the first colour.
  raster(int w, int h, std::vector<colour> colours);
  /// Outside the picture nothing happens.
  void fill(int x, int y, int w, int h, shade);
  /// Left and top end of the text; every dot becomes scale x scale pixels.
  void text(int x, int y, std::string_view, int scale, shade);
  static int text_width(std::string_view, int scale);
};

}  // namespace polhode::report
