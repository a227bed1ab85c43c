// SPDX-License-Identifier: Apache-2.0
#include "selection/snippet.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace polhode {
namespace {

/// What the program is made of.
struct program {
  const subject& of;
  const candidate& who;
  int cells;

  std::string_view scheme() const { return who.scheme.info.name; }
  std::size_t size() const { return of.scene.momentum.size(); }
  bool sized() const { return of.offers->in_cpp_sized; }
  bool areas() const { return who.scheme.needs_areas; }
  bool own_loop() const { return areas(); }  ///< `integrate` draws increments alone
};

std::string includes_of(const program& p) {
  const auto& own = p.of.offers->in_cpp_header;
  std::string out = "#include <cmath>\n#include <cstdint>\n#include <cstdio>\n#include <vector>\n";
  for (const auto& name : {std::string("integrate"), fmt::format("schemes/{}", p.scheme()),
                           fmt::format("systems/{}", own.empty() ? p.of.scene.system : own)})
    out += fmt::format("#include <polhode/{}.hpp>\n", name);
  return out;
}

std::string start_of(const program& p) {
  const auto numbers = fmt::format("{}", fmt::join(p.of.scene.momentum, ", "));
  if (!p.sized()) return fmt::format("  const vec<double, {}> start{{{{{}}}}};\n", p.size(), numbers);
  return fmt::format(
      "  const std::vector<double> momentum{{{}}};\n  auto start = zeros<state_of<decltype(body)>>({});\n"
      "  for (int i = 0; i < start.size; ++i) start[i] = momentum[static_cast<std::size_t>(i)];\n",
      numbers, p.size());
}

/// Areas of a path come from the cells inside a step; where the law alone is asked for they are drawn, independent and
/// of the right variance.
std::string drawn_areas(const program& p) {
  if (!p.areas()) return "";
  std::string out = "    w.area = zeros<decltype(w.area)>(pairs_among(w.dw.size));\n";
  if (p.cells == 1)
    out += R"(    for (int i = 0; i < pairs_among(body.active_channels()); ++i)
      w.area[i] = time / 2 * normal_pair({.seed = 1, .kind = noise_kind::area, .path = path, .step = step}, i / 2)[i % 2];
)";
  return out;
}

/// What `integrate` does for those that it takes.
std::string noise_of(const program& p) {
  if (!p.own_loop()) return "";
  return fmt::format(R"(  const auto stepped = prepared<{}>(body, dt);
  const auto noise_of = [&](std::uint64_t path, std::uint64_t step, double time) {{
    wiener{}<double, decltype(body)::channels> w;
    w.dt = time;
    w.dw = zeros<decltype(w.dw)>({});
    for (int i = 0; i < body.active_channels(); ++i)
      w.dw[i] = std::sqrt(time) * normal_pair({{.seed = 1, .path = path, .step = step}}, i / 2)[i % 2];
{}    return w;
  }};
)",
                     p.scheme(), p.areas() ? "_levy" : "", p.size(), drawn_areas(p));
}

std::string path_of(const program& p, const char* dt, const char* steps) {
  return fmt::format("integrate<{}>(body, start, {}, {}, {{.seed = 1, .path = path}})", p.scheme(), dt, steps);
}

std::string step_of(const program& p) {
  if (!p.areas() || p.cells == 1)
    return fmt::format("      mu = {}::step(stepped, mu, noise_of(path, step, dt));\n", p.scheme());
  return fmt::format(
      R"(      auto w = noise_of(path, {0} * step, dt / {0});  // increments and Levy areas of this step, from {0} cells
      for (std::uint64_t cell = 1; cell < {0}; ++cell) w = chen(w, noise_of(path, {0} * step + cell, dt / {0}));
      mu = {1}::step(stepped, mu, w);
)",
      p.cells, p.scheme());
}

std::string loop_of(const program& p) {
  if (p.own_loop())
    return fmt::format(
        "    auto mu = start;\n    for (std::uint64_t step = 0; step < steps; ++step) {{\n{}    }}\n"
        "    energy += body.energy(mu) / paths;\n",
        step_of(p));
  if (p.who.combination == nullptr)
    return fmt::format("    energy += body.energy({}) / paths;\n", path_of(p, "dt", "steps"));
  return fmt::format(
      "    const auto coarse = {};\n    const auto fine = {};\n"
      "    energy += (4 * body.energy(fine) - body.energy(coarse)) / 3 / paths;\n",
      path_of(p, "dt", "steps"), path_of(p, "dt / 2", "2 * steps"));
}

}  // namespace

std::string snippet(const subject& of, const candidate& who, double dt, double time, int cells) {
  const program p{of, who, cells};
  return fmt::format(R"({}
int main() {{
  using namespace polhode;
{}{}  const double dt = {:.17g};
  const std::uint64_t steps = {};
  constexpr int paths = 1000;
{}  double energy = 0;
  for (std::uint64_t path = 0; path < paths; ++path) {{
{}  }}
  std::printf("mean energy after %g: %.6f\n", dt * static_cast<double>(steps), energy);
}}
)",
                     includes_of(p), of.offers->in_cpp, start_of(p), dt, std::max(1L, std::lround(time / dt)),
                     noise_of(p), loop_of(p));
}

}  // namespace polhode
