#include "selection/snippet.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace polhode {
namespace {

std::string path_of(const candidate& who, const std::string& dt, const std::string& steps) {
  const auto name = who.scheme.info.name;
  return fmt::format("integrate<{}>(body, start, {}, {}, {{.seed = 1, .path = path}})", name, dt, steps);
}

/// Areas of a path come from the cells inside a step.
std::string stepper_with_areas(const candidate& who, int cells, std::size_t channels) {
  return fmt::format(R"(    auto pi = start;
    for (std::uint64_t step = 0; step < steps; ++step) {{
      wiener_levy<double, {2}> w;  // increments and Levy areas of this step, from {0} cells
      for (std::uint64_t cell = 0; cell < {0}; ++cell) {{
        wiener_levy<double, {2}> part;
        static_cast<wiener<double, {2}>&>(part) =
            wiener_at<{2}>({{.seed = 1, .path = path, .step = {0} * step + cell}}, dt / {0}, body.active_channels());
        w = chen(w, part);
      }}
      pi = {1}::step(body, pi, w);
    }}
    energy += body.energy(pi) / paths;
)",
                     cells, who.scheme.info.name, channels);
}

std::string loop_of(const candidate& who, int cells, std::size_t channels) {
  if (who.scheme.needs_areas) return stepper_with_areas(who, cells, channels);
  if (who.combination == nullptr)
    return fmt::format("    energy += body.energy({}) / paths;\n", path_of(who, "dt", "steps"));
  return fmt::format(
      "    const auto coarse = {};\n    const auto fine = {};\n"
      "    energy += (4 * body.energy(fine) - body.energy(coarse)) / 3 / paths;\n",
      path_of(who, "dt", "steps"), path_of(who, "dt / 2", "2 * steps"));
}

}  // namespace

std::string snippet(const subject& of, const candidate& who, double dt, double time, int cells) {
  const auto& s = of.scene;
  std::string head = "#include <cstdint>\n#include <cstdio>\n";
  for (const auto& name :
       {std::string("integrate"), fmt::format("schemes/{}", who.scheme.info.name), fmt::format("systems/{}", s.system)})
    head += fmt::format("#include <polhode/{}.hpp>\n", name);
  return fmt::format(R"({0}
int main() {{
  using namespace polhode;
{1}  const vec<double, {6}> start{{{{{2}}}}};
  const double dt = {3:.17g};
  const std::uint64_t steps = {4};
  constexpr int paths = 1000;
  double energy = 0;
  for (std::uint64_t path = 0; path < paths; ++path) {{
{5}  }}
  std::printf("mean energy after %g: %.6f\n", dt * static_cast<double>(steps), energy);
}}
)",
                     head, of.offers->in_cpp, fmt::join(s.momentum, ", "), dt, std::max(1L, std::lround(time / dt)),
                     loop_of(who, cells, s.momentum.size()), s.momentum.size());
}

}  // namespace polhode
