// Where the bodies are: the logarithm of their density on the whole sphere (Mollweide's projection, equal area) and on
// two hemispheres seen from outside (orthographic).
#pragma once

#include <cstdint>
#include <vector>

#include "reports/model/simulation.hpp"
#include "reports/writers/raster.hpp"

namespace polhode::report {

/// Made once for many pictures: which bins of a snapshot each pixel sees.
class density_picture {
 public:
  explicit density_picture(int side);  ///< of the squares of ensemble_snapshot::picture
  raster paint(const simulation&, const ensemble_snapshot&) const;

 private:
  static constexpr int samples = 4;
  struct pixel {
    int x, y, inside;  ///< how many of the samples are on the sphere
    std::uint32_t bins[samples];
  };
  template <class Direction>
  void add_disc(int left, int top, int width, int height, Direction direction);

  int side_;
  std::vector<pixel> pixels_;
};

}  // namespace polhode::report
