// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/raster.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "reports/writers/font.hpp"

namespace polhode::report {

raster::raster(int w, int h, std::vector<colour> colours)
    : width(w),
      height(h),
      palette(std::move(colours)),
      pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}

void raster::fill(int x, int y, int w, int h, shade c) {
  const int left = std::max(x, 0), right = std::min(x + w, width);
  for (int j = std::max(y, 0); j < std::min(y + h, height) && left < right; ++j)
    std::fill_n(pixels.begin() + static_cast<std::ptrdiff_t>(j) * width + left, right - left, c);
}

void raster::text(int x, int y, std::string_view text, int scale, shade c) {
  for (const char letter : text) {
    const auto& columns = glyph_of(letter);
    for (int i = 0; i < glyph_width; ++i)
      for (int j = 0; j < glyph_height; ++j)
        if ((columns[static_cast<std::size_t>(i)] >> j & 1) != 0) fill(x + i * scale, y + j * scale, scale, scale, c);
    x += glyph_advance * scale;
  }
}

int raster::text_width(std::string_view text, int scale) {
  return (static_cast<int>(text.size()) * glyph_advance - 1) * scale;
}

}  // namespace polhode::report
