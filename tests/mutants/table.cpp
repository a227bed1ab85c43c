#include "mutants/table.hpp"

#include <algorithm>

#include "registry/scene.hpp"

namespace polhode::test {
namespace {

using names = std::vector<std::string_view>;

/// Sizes `asked` for and `beyond`, each on every scheme and scene.
struct block {
  test::kind kind;
  std::vector<double> asked, beyond;
  names schemes, scenes;
};

const names all = {"euler_maruyama",    "heun",      "heun_projected", "milstein",    "milstein_no_area",
                   "implicit_midpoint", "lie_euler", "lie_heun",       "cayley_heun", "magnus",
                   "lie_trotter",       "strang",    "strang_weak2"};
const names orders = {"lie_trotter", "lie_heun", "strang_weak2"};  // weak orders 1, 1 and 2; splitting and not
const names paper = {"paper"}, others = {"weak noise", "anisotropic"}, three = {"paper", "weak noise", "anisotropic"};

std::vector<block> blocks() {
  return {
      // Parameters: of the noise and of the dissipation for all schemes, as each claims a weak order.
      {kind::noise, {-0.001, 0.001, 0.01, 0.05}, {}, all, paper},
      {kind::noise, {0.001, 0.01, 0.05}, {}, orders, others},
      {kind::noise, {0.001, 0.01, 0.05, 0.5}, {}, {"strang", "heun"}, {"hard"}},
      {kind::theta, {-0.001, 0.001, 0.01, 0.05}, {}, all, paper},
      {kind::theta, {0.001, 0.01, 0.05}, {}, orders, others},
      {kind::theta, {0.001, 0.01, 0.05, 0.2}, {}, {"strang", "heun"}, {"hard"}},
      {kind::inertia_1, {0.01, 0.05}, {0.001}, orders, three},
      {kind::inertia_2, {0.01, 0.05}, {0.001}, orders, three},
      {kind::inertia_3, {0.01, 0.05}, {0.001}, orders, three},
      {kind::channel_1, {0.01, 0.05}, {0.001}, orders, three},
      // Time.
      {kind::sub_flow, {0.01, 0.05}, {0.001}, {"lie_trotter", "strang", "strang_weak2"}, three},
      {kind::horizon, {-0.01, 0.01}, {-0.001, 0.001}, orders, three},
      {kind::step_count,
       {-1, 1},
       {},
       {"euler_maruyama", "lie_euler", "lie_trotter", "lie_heun", "strang_weak2"},
       three},
      // Increments.
      {kind::dw, {0.01, 0.05}, {0.001}, {"magnus", "cayley_heun", "heun"}, three},
      {kind::area, {-2, 0.05}, {0.01}, {"magnus", "milstein"}, {"paper", "anisotropic"}},
      {kind::area_mixed, {1}, {}, {"magnus"}, {"paper", "anisotropic"}},
      {kind::channels, {1, 0.3, 0.05, 0.01}, {0.001}, {"lie_heun", "strang_weak2"}, three},
      {kind::lanes, {32, 1}, {}, {"lie_heun", "strang"}, paper},
      {kind::steps, {1}, {}, {"lie_heun", "strang"}, paper},
      {kind::clip, {2, 3}, {4, 5}, {"lie_heun", "strang_weak2"}, {"paper", "anisotropic"}},
      {kind::branch, {3, 5}, {4}, {"lie_heun", "strang_weak2"}, {"paper", "anisotropic"}},
      // States.
      {kind::float_state, {1}, {}, {"lie_heun", "strang", "heun"}, paper},
      {kind::float_projected, {1}, {}, {"lie_heun", "strang"}, {"paper", "weak noise"}},
      {kind::turn, {0.01, 0.05}, {0.001}, orders, three},
      {kind::shrink, {0.01}, {0.001, 1e-6}, {"heun", "lie_heun"}, paper},
      {kind::ito_drift,
       {-1, 1, -0.05, 0.05, 0.01},
       {0.001},
       {"euler_maruyama", "milstein", "heun"},
       {"paper", "anisotropic"}},
      // Inside the step.
      {kind::dissipation_sign, {1}, {}, {"lie_heun"}, three},
      {kind::weights, {0.01, 0.05, 0.5}, {0.001}, {"lie_heun"}, three},
      {kind::half_missing, {0.01, 0.05, 1}, {0.001}, {"heun"}, {"paper", "anisotropic"}},
      {kind::stage, {0.01, 0.05, 1}, {0.001}, {"lie_heun"}, three},
      {kind::halves, {0.01, 0.05, 1}, {0.001}, {"strang"}, three},
      {kind::exponential, {1}, {}, {"lie_euler"}, three},
      // Claims.
      {kind::strong_claim, {0.5}, {}, all, {"paper", "weak noise", "single"}},
      {kind::weak_claim, {1}, {}, all, paper},
      {kind::weak_claim, {1}, {}, {"strang", "lie_heun", "lie_trotter"}, {"sigma 0.1", "weak noise", "anisotropic"}},
      {kind::path_claim, {1}, {}, all, paper},
      {kind::drift_claim, {0.5}, {}, {"euler_maruyama", "heun", "milstein", "milstein_no_area"}, paper},
      {kind::casimir_claim, {1}, {}, {"euler_maruyama", "heun", "milstein", "milstein_no_area"}, three},
  };
}

report::scene with_noise(double sigma, std::string name) {
  auto s = load_scene("paper");
  s.name = std::move(name);
  for (std::size_t i = 0; i < 3; ++i) s.sigma[i][i] = sigma;
  return s;
}

/// Fast and noisy: no transfer operator of a scheme that leaves the sphere resolves it, so that weak errors are
/// sampled.
report::scene hard() {
  auto s = load_scene("anisotropic");
  s.name = "hard";
  s.momentum = {3, 2.4, 3.2};
  s.sigma = {{1.0, 0, 0}, {0, 1.5, 0}, {0.5, 0, 2.0}};
  return s;
}

}  // namespace

report::scene scene_named(std::string_view name) {
  if (name == "weak noise") return with_noise(0.05, "weak noise");
  if (name == "sigma 0.1") return with_noise(0.1, "sigma 0.1");
  if (name == "hard") return hard();
  return load_scene(name);
}

std::vector<row> table() {
  std::vector<row> rows;
  for (const auto& b : blocks())
    for (const auto scheme : b.schemes)
      for (const auto scene : b.scenes) {
        for (const double size : b.asked) rows.push_back({{b.kind, size}, scheme, scene, true});
        for (const double size : b.beyond) rows.push_back({{b.kind, size}, scheme, scene, false});
      }
  return rows;
}

std::vector<row> sharpest() {
  return {
      {{kind::noise, 0.01}, "lie_heun", "paper", true},
      {{kind::theta, 0.01}, "strang", "paper", true},
  };
}

std::string_view claim_of(kind k) {
  switch (k) {
    case kind::strong_claim: return "strong order";
    case kind::weak_claim: return "weak order";
    case kind::path_claim: return "order of the";
    case kind::drift_claim: return "order of the Casimir drift";
    case kind::casimir_claim: return "Casimirs kept to rounding";
    default: return "";
  }
}

}  // namespace polhode::test
