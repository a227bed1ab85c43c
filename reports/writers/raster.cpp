#include "reports/writers/raster.hpp"

#include <algorithm>
#include <cmath>
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

colour viridis(double t) {
  constexpr double coefficients[3][7] = {{0.2777273272234177, 0.1050930431085774, -0.3308618287255563,
                                          -4.634230498983486, 6.228269936347081, 4.776384997670288, -5.435455855934631},
                                         {0.005407344544966578, 1.404613529898575, 0.214847559468213,
                                          -5.799100973351585, 14.17993336680509, -13.74514537774601, 4.645852612178535},
                                         {0.3340998053353061, 1.384590162594685, 0.09509516302823659,
                                          -19.33244095627987, 56.69055260068105, -65.35303263337234, 26.3124352495832}};
  colour out{};
  for (std::size_t k = 0; k < 3; ++k) {
    double value = 0;
    for (int power = 6; power >= 0; --power) value = value * t + coefficients[k][power];
    out[k] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
  }
  return out;
}

}  // namespace polhode::report
