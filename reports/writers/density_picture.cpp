// SPDX-License-Identifier: Apache-2.0
#include "reports/writers/density_picture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "reports/model/text.hpp"

namespace polhode::report {
namespace {

// Which bins of a snapshot the samples of a picture see, row by row.

constexpr auto outside = std::numeric_limits<std::uint32_t>::max();  ///< no bin: beside the sphere

using sample_row = std::vector<std::uint32_t>;

using std::numbers::pi;

/// The bins of a snapshot: Lambert's equal-area projection of each hemisphere, as ensemble_snapshot::picture says.
struct lambert {
  int side;
  static double scale_at(double z) { return 0.5 / std::sqrt(1 + std::abs(z)); }
  int cell(double u) const { return std::clamp(static_cast<int>((u + 0.5) * side), 0, side - 1); }
  /// x and y are scaled already.
  std::uint32_t bin(double x, double y, bool below) const {
    return static_cast<std::uint32_t>(((below ? side : 0) + cell(y)) * side + cell(x));
  }
};

// A row is a circle of latitude, run through by a rotation. Source: Snyder, Map Projections (1987), eqs. (31-6) to
// (31-8).
/// Samples at x = (k + 1/2)/w - 1 of the row at y in (-1, 1), upwards, k = 0 … 2w - 1, on the unit disc: Mollweide's
/// projection of the whole sphere, and the hemispheres z >= 0 and z < 0 seen from outside (orthographic). Bins as in
/// ensemble_snapshot::picture, in squares of side^2.
void mollweide_row(int side, double y, sample_row& out) {
  const lambert bins{side};
  const double a = std::asin(y), w = 0.5 * static_cast<double>(out.size()), half = std::cos(a);
  const double z = std::clamp((2 * a + std::sin(2 * a)) / pi, -1.0, 1.0);
  const double r = std::sqrt(1 - z * z) * lambert::scale_at(z);
  const auto first = static_cast<std::size_t>(std::max(0.0, std::ceil(w * (1 - half) - 0.5)));
  const double start = pi * ((static_cast<double>(first) + 0.5) / w - 1) / half, step = pi / (w * half);
  const double cos = std::cos(step), sin = std::sin(step);
  double east = r * std::cos(start), north = r * std::sin(start);
  std::ranges::fill(out, outside);
  for (std::size_t k = first; k + first < out.size(); ++k) {
    out[k] = bins.bin(east, north, z < 0);
    const double turned = east * cos - north * sin;
    north = north * cos + east * sin;
    east = turned;
  }
}

void upper_row(int side, double y, sample_row& out) {
  const lambert bins{side};
  const double w = 0.5 * static_cast<double>(out.size());
  for (std::size_t k = 0; k < out.size(); ++k) {
    const double x = (static_cast<double>(k) + 0.5) / w - 1, z2 = 1 - x * x - y * y;
    const double scale = lambert::scale_at(std::sqrt(std::max(0.0, z2)));
    out[k] = z2 > 0 ? bins.bin(x * scale, y * scale, false) : outside;
  }
}

// Seen from below x runs to the left.
void lower_row(int side, double y, sample_row& out) {
  upper_row(side, y, out);
  std::ranges::reverse(out);
  for (auto& bin : out)
    if (bin != outside) bin += static_cast<std::uint32_t>(side * side);
}

constexpr int picture_width = 1200, picture_height = 1170;
constexpr int map_left = 60, map_top = 90, map_width = 1080, map_height = 540;
constexpr int disc = 440, disc_top = 680, upper_left = 60, lower_left = 545;
constexpr int bar_left = 1040, bar_top = 720, bar_width = 30, bar_height = 360;

// The palette: a few colours by name, what the sphere's rim looks like by the share that it covers, and the densities.
constexpr shade paper = 0, ink = 1, grey = 2, empty = 3, first_rim = 4, first_density = 7;
constexpr int densities = 256 - first_density;
constexpr colour paper_colour{255, 255, 255}, ink_colour{20, 20, 20}, grey_colour{80, 80, 80}, empty_colour{30, 22, 44};

std::vector<colour> palette(const colour_map& map) {
  std::vector<colour> out{paper_colour, ink_colour, grey_colour, empty_colour};
  for (int quarters = 1; quarters < 4; ++quarters) {
    colour rim{};
    for (std::size_t k = 0; k < 3; ++k)
      rim[k] = static_cast<std::uint8_t>((quarters * empty_colour[k] + (4 - quarters) * paper_colour[k]) / 4);
    out.push_back(rim);
  }
  for (int i = 0; i < densities; ++i) out.push_back(map.at(map.first + (1 - map.first) * i / (densities - 1.0)));
  return out;
}

shade density_shade(double place) { return static_cast<shade>(first_density + std::lround(place * (densities - 1))); }

/// Densities relative to bodies spread evenly, from dark to bright.
struct colour_scale {
  double low, high;
  double place(double density) const { return std::clamp(std::log(density / low) / std::log(high / low), 0.0, 1.0); }
};

void draw_bar(raster& out, const colour_scale& scale) {
  for (int y = 0; y < bar_height; ++y)
    out.fill(bar_left, bar_top + y, bar_width, 1, density_shade(1 - (y + 0.5) / bar_height));
  out.fill(bar_left, bar_top + bar_height + 10, bar_width, 20, empty);
  out.text(bar_left + bar_width + 12, bar_top + bar_height + 13, "empty", 2, ink);
  const bool roomy = scale.high < 1000 * scale.low;
  for (int decade = -12; decade <= 12; ++decade)
    for (int minor = 1; minor < 10; ++minor) {
      const double value = minor * std::pow(10.0, decade);
      if (value < scale.low || value > scale.high) continue;
      const bool named = minor == 1 || (roomy && (minor == 2 || minor == 5));
      const int y = bar_top + static_cast<int>(std::lround((1 - scale.place(value)) * (bar_height - 1)));
      out.fill(bar_left + bar_width, y - 1, named ? 9 : 5, 2, ink);
      if (named) out.text(bar_left + bar_width + 14, y - 7, fmt::format("{:.3g}", value), 2, ink);
    }
  out.text(bar_left - 40, bar_top - 54, "density", 2, ink);
  out.text(bar_left - 40, bar_top - 34, "(uniform = 1)", 2, ink);
}

/// White on dark, as the name may stand on any density.
void mark_axis(raster& out, int x, int y, std::string_view name) {
  for (const int edge : {2, 0}) {
    const shade c = edge > 0 ? empty : paper;
    out.fill(x - 7 - edge, y - 1 - edge, 14 + 2 * edge, 2 + 2 * edge, c);
    out.fill(x - 1 - edge, y - 7 - edge, 2 + 2 * edge, 14 + 2 * edge, c);
    for (int dx = -edge; dx <= edge; ++dx)
      for (int dy = -edge; dy <= edge; ++dy) out.text(x + 9 + dx, y + 6 + dy, name, 2, c);
  }
}

/// Where the axes of the body pierce the sphere.
void mark_axes(raster& out) {
  constexpr int middle = map_top + map_height / 2, quarter = map_width / 4;
  mark_axis(out, map_left + 2 * quarter, middle, "+e1");
  mark_axis(out, map_left + 3 * quarter, middle, "+e2");
  mark_axis(out, map_left + quarter, middle, "-e2");
  mark_axis(out, upper_left + disc / 2, disc_top + disc / 2, "+e3");
  mark_axis(out, lower_left + disc / 2, disc_top + disc / 2, "-e3");
}

std::string in_short(const parameter& p) {
  if (p.shape == shape::word) return p.word;
  if (p.shape == shape::number) return fmt::format("{:.6g}", p.rows[0][0]);
  if (p.shape == shape::vector) return fmt::format("({:.6g})", fmt::join(p.rows[0], ", "));
  std::string out;
  for (const auto& row : p.rows) out += fmt::format("{}({:.4g})", out.empty() ? "" : " ", fmt::join(row, ", "));
  return out.empty() ? "0" : out;
}

void draw_titles(raster& out, const simulation& s, const ensemble_snapshot& shown) {
  const auto first = fmt::format("{}: {}, dt = {:.6g}, t = {:.6g}", one_line(s.scene.name).substr(0, 40), s.scheme.name,
                                 s.dt, shown.state.time);
  std::string second;
  for (const auto& p : s.scene.parameters)
    second += fmt::format("{}{} = {}", second.empty() ? "" : "   ", p.name, in_short(p));
  const auto third = fmt::format("{} bodies ({} lost)   {} noise   {} start   seed {}", s.bodies, shown.state.lost,
                                 s.noise, s.start, s.provenance.seed);
  out.text(map_left, 14, first, 3, ink);
  out.text(map_left, 46, second.substr(0, 90), 2, grey);
  out.text(map_left, 66, third, 2, grey);
  const auto below = [&](int left, const std::string& text) {
    out.text(left + disc / 2 - raster::text_width(text, 2) / 2, disc_top + disc + 14, text, 2, ink);
  };
  const auto up = s.component(static_cast<std::size_t>(s.pictured) + 2);
  below(upper_left, up + " > 0");
  below(lower_left, up + " < 0");
}

}  // namespace

density_picture::density_picture(int side, const colour_map& map) : palette_(palette(map)) {
  pixels_.reserve(std::size_t{map_width} * map_height + std::size_t{2} * disc * disc);
  add_disc(map_left, map_top, map_width, map_height, [&](double y, auto& row) { mollweide_row(side, y, row); });
  add_disc(upper_left, disc_top, disc, disc, [&](double y, auto& row) { upper_row(side, y, row); });
  add_disc(lower_left, disc_top, disc, disc, [&](double y, auto& row) { lower_row(side, y, row); });
}

/// Four samples a pixel: of two rows, two neighbours each.
template <class Bins>
void density_picture::add_disc(int left, int top, int w, int h, Bins bins_of_row) {
  std::vector<std::uint32_t> first(static_cast<std::size_t>(2 * w)), second(first);
  for (int j = 0; j < h; ++j) {
    bins_of_row(1 - (2 * j + 0.5) / h, first);
    bins_of_row(1 - (2 * j + 1.5) / h, second);
    for (std::size_t i = 0; i < static_cast<std::size_t>(w); ++i) {
      const auto place = static_cast<std::uint32_t>((top + j) * picture_width + left) + static_cast<std::uint32_t>(i);
      const std::array bins{first[2 * i], first[2 * i + 1], second[2 * i], second[2 * i + 1]};
      const auto inside = samples - static_cast<int>(std::ranges::count(bins, outside));
      if (inside == samples)
        pixels_.push_back({place, bins});
      else if (inside > 0)
        rim_.push_back({place, inside});
    }
  }
}

raster density_picture::paint(const simulation& s, const ensemble_snapshot& shown) const {
  const double bodies = static_cast<double>(std::max<std::int64_t>(1, s.bodies - shown.state.lost));
  const double even = bodies / (0.5 * pi * shown.side * shown.side);  // bodies in a bin where all are spread evenly
  std::vector<std::uint64_t> sums;
  sums.reserve(pixels_.size());
  for (const auto& p : pixels_) {
    std::uint64_t sum = 0;
    for (const auto bin : p.bins) sum += shown.picture[bin];
    sums.push_back(sum);
  }
  const auto most = static_cast<double>(*std::ranges::max_element(sums));
  const colour_scale scale{0.5 / even, std::max(10.0, most / samples) / even};
  const auto shade_of = [&](std::uint64_t sum) {
    return sum == 0 ? empty : density_shade(scale.place(static_cast<double>(sum) / (samples * even)));
  };
  std::array<shade, 256> usual{};  // most pixels see a few bodies only
  for (std::size_t sum = 0; sum < usual.size(); ++sum) usual[sum] = shade_of(sum);
  raster out(picture_width, picture_height, palette_);
  for (std::size_t i = 0; i < sums.size(); ++i)
    out.pixels[pixels_[i].place] = sums[i] < usual.size() ? usual[sums[i]] : shade_of(sums[i]);
  for (const auto& p : rim_) out.pixels[p.place] = static_cast<shade>(first_rim + p.inside - 1);
  draw_bar(out, scale);
  mark_axes(out);
  draw_titles(out, s, shown);
  return out;
}

}  // namespace polhode::report
