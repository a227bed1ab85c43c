// SPDX-License-Identifier: Apache-2.0
// Where the bodies are: the logarithm of their density on the whole sphere (Mollweide's projection, equal area) and on
// two hemispheres seen from outside (orthographic).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "reports/model/simulation.hpp"
#include "reports/writers/colour_map.hpp"
#include "reports/writers/raster.hpp"

namespace polhode::report {

/// Made once for many pictures: which bins of a snapshot each pixel sees.
class density_picture {
 public:
  /// side: of the squares of ensemble_snapshot::picture.
  explicit density_picture(int side, const colour_map& = colour_maps().front());
  raster paint(const simulation&, const ensemble_snapshot&) const;

 private:
  static constexpr int samples = 4;  // a pixel
  struct pixel {
    std::uint32_t place;  ///< in the raster
    std::array<std::uint32_t, samples> bins;
  };
  struct rim_pixel {
    std::uint32_t place;
    int inside;  ///< how many of the samples are on the sphere
  };
  template <class Bins>
  void add_disc(int left, int top, int width, int height, Bins bins_of_row);

  std::vector<colour> palette_;
  std::vector<pixel> pixels_;
  std::vector<rim_pixel> rim_;
};

}  // namespace polhode::report
