#include "reports/writers/density_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "reports/writers/numbers.hpp"
#include "reports/writers/text.hpp"

namespace polhode::report {
namespace {

using vector3 = std::array<double, 3>;
constexpr double pi = std::numbers::pi;
constexpr int width = 1200, height = 1170;
constexpr int map_left = 60, map_top = 90, map_width = 1080, map_height = 540;
constexpr int disc = 440, disc_top = 680, upper_left = 60, lower_left = 545;
constexpr int bar_left = 1040, bar_top = 720, bar_width = 30, bar_height = 360;
constexpr colour paper{255, 255, 255}, ink{20, 20, 20}, grey{110, 110, 110}, empty{30, 22, 44}, mark{255, 255, 255};

/// The bin of a direction: Lambert's equal-area projection of each hemisphere, as ensemble_snapshot::picture says.
std::uint32_t bin_of(const vector3& n, int side) {
  const double scale = 0.5 / std::sqrt(1 + std::abs(n[2]));
  const auto cell = [&](double u) { return std::clamp(static_cast<int>((u * scale + 0.5) * side), 0, side - 1); };
  return static_cast<std::uint32_t>(((n[2] < 0 ? side : 0) + cell(n[1])) * side + cell(n[0]));
}

/// From x, y in the unit disc, y upwards. Source: Snyder, Map Projections (1987), eqs. (31-6) to (31-8).
vector3 from_mollweide(double x, double y) {
  const double a = std::asin(y), z = std::clamp((2 * a + std::sin(2 * a)) / pi, -1.0, 1.0);
  const double longitude = pi * x / std::cos(a), r = std::sqrt(1 - z * z);
  return {r * std::cos(longitude), r * std::sin(longitude), z};
}

vector3 from_above(double x, double y) { return {x, y, std::sqrt(std::max(0.0, 1 - x * x - y * y))}; }
vector3 from_below(double x, double y) { return {-x, y, -std::sqrt(std::max(0.0, 1 - x * x - y * y))}; }

/// Densities relative to bodies spread evenly, from black to yellow.
struct colour_scale {
  double low, high;
  double place(double density) const { return std::clamp(std::log(density / low) / std::log(high / low), 0.0, 1.0); }
};

void draw_bar(raster& out, const colour_scale& scale) {
  for (int y = 0; y < bar_height; ++y)
    out.fill(bar_left, bar_top + y, bar_width, 1, viridis(1 - (y + 0.5) / bar_height));
  out.fill(bar_left, bar_top + bar_height + 10, bar_width, 20, empty);
  out.text(bar_left + bar_width + 12, bar_top + bar_height + 13, "empty", 2, ink);
  for (int decade = -12; decade <= 12; ++decade)
    for (int minor = 1; minor < 10; ++minor) {
      const double value = minor * std::pow(10.0, decade);
      if (value < scale.low || value > scale.high) continue;
      const int y = bar_top + static_cast<int>(std::lround((1 - scale.place(value)) * (bar_height - 1)));
      out.fill(bar_left + bar_width, y, minor == 1 ? 9 : 5, minor == 1 ? 2 : 1, ink);
      if (minor > 1) continue;
      out.text(bar_left + bar_width + 14, y - 6, "10", 2, ink);
      out.text(bar_left + bar_width + 40, y - 12, std::to_string(decade), 1, ink);
    }
  out.text(bar_left - 40, bar_top - 44, "density", 2, ink);
  out.text(bar_left - 40, bar_top - 22, "(uniform = 1)", 2, ink);
}

void mark_axis(raster& out, int x, int y, std::string_view name) {
  out.fill(x - 5, y, 11, 1, mark);
  out.fill(x, y - 5, 1, 11, mark);
  out.text(x + 8, y + 5, name, 2, mark);
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

void draw_titles(raster& out, const simulation& s, const ensemble_snapshot& shown) {
  const auto first = fmt::format("{}: {}, dt = {:.6g}, t = {:.6g}", one_line(s.scene.name).substr(0, 40), s.scheme.name,
                                 s.dt, shown.state.time);
  std::string sigma;
  for (const auto& v : s.scene.sigma) sigma += fmt::format("({:.4g} {:.4g} {:.4g})", v[0], v[1], v[2]);
  const auto& i = s.scene.inertia;
  const auto second = fmt::format("I = ({:.6g} {:.6g} {:.6g})   theta = {:.6g}   sigma = {}", i[0], i[1], i[2],
                                  s.scene.theta, sigma.empty() ? "0" : sigma);
  const auto third = fmt::format("{} bodies ({} lost)   {} noise   {} start   seed {}", s.bodies, shown.state.lost,
                                 s.noise, s.start, s.provenance.seed);
  out.text(map_left, 14, first, 3, ink);
  out.text(map_left, 46, second.substr(0, 90), 2, grey);
  out.text(map_left, 66, third, 2, grey);
  out.text(upper_left + disc / 2 - raster::text_width("pi3 > 0", 2) / 2, disc_top + disc + 14, "pi3 > 0", 2, ink);
  out.text(lower_left + disc / 2 - raster::text_width("pi3 < 0", 2) / 2, disc_top + disc + 14, "pi3 < 0", 2, ink);
}

colour blended(colour over, double share) {
  for (std::size_t k = 0; k < 3; ++k)
    over[k] = static_cast<std::uint8_t>(std::lround(share * over[k] + (1 - share) * paper[k]));
  return over;
}

}  // namespace

density_picture::density_picture(int side) : side_(side) {
  add_disc(map_left, map_top, map_width, map_height, from_mollweide);
  add_disc(upper_left, disc_top, disc, disc, from_above);
  add_disc(lower_left, disc_top, disc, disc, from_below);
}

template <class Direction>
void density_picture::add_disc(int left, int top, int w, int h, Direction direction) {
  for (int j = 0; j < h; ++j)
    for (int i = 0; i < w; ++i) {
      pixel p{left + i, top + j, 0, {}};
      for (int s = 0; s < samples; ++s) {
        const double x = 2 * (i + 0.25 + 0.5 * (s % 2)) / w - 1, y = 1 - 2 * (j + 0.25 + 0.5 * (s / 2)) / h;
        if (x * x + y * y < 1) p.bins[p.inside++] = bin_of(direction(x, y), side_);
      }
      if (p.inside > 0) pixels_.push_back(p);
    }
}

raster density_picture::paint(const simulation& s, const ensemble_snapshot& shown) const {
  const double bodies = static_cast<double>(std::max<std::int64_t>(1, s.bodies - shown.state.lost));
  const double even = bodies / (0.5 * pi * side_ * side_);  // bodies in a bin where all are spread evenly
  const auto density = [&](const pixel& p) {
    double sum = 0;
    for (int i = 0; i < p.inside; ++i) sum += shown.picture[p.bins[i]];
    return sum / (p.inside * even);
  };
  colour_scale scale{0.5 / even, 20 / even};
  for (const auto& p : pixels_) scale.high = std::max(scale.high, density(p));
  raster out(width, height, paper);
  for (const auto& p : pixels_) {
    const double d = density(p);
    out.set(p.x, p.y, blended(d > 0 ? viridis(scale.place(d)) : empty, static_cast<double>(p.inside) / samples));
  }
  draw_bar(out, scale);
  mark_axes(out);
  draw_titles(out, s, shown);
  return out;
}

}  // namespace polhode::report
