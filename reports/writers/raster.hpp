// A picture of pixels to draw into.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace polhode::report {

using colour = std::array<std::uint8_t, 3>;

struct raster {
  int width, height;
  std::vector<std::uint8_t> pixels;  ///< rows from the top, three bytes a pixel

  raster(int w, int h, colour background);
  /// Outside the picture nothing happens.
  void set(int x, int y, colour);
  void fill(int x, int y, int w, int h, colour);
  /// Left and top end of the text; every dot becomes scale x scale pixels.
  void text(int x, int y, std::string_view, int scale, colour);
  static int text_width(std::string_view, int scale);
};

/// Blue-violet to yellow, evenly brighter, t in [0, 1]. Source: matplotlib's viridis (van der Walt, Smith), as the
/// polynomial of sixth degree fitted by M. Zucker (shadertoy WlfXRN, CC0).
colour viridis(double t);

}  // namespace polhode::report
