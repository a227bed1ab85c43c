// The rigid body meets its schemes. Adding a scheme: its header, and its name in the list below.
#include <polhode/schemes/cayley_heun.hpp>
#include <polhode/schemes/euler_maruyama.hpp>
#include <polhode/schemes/heun.hpp>
#include <polhode/schemes/heun_projected.hpp>
#include <polhode/schemes/implicit_midpoint.hpp>
#include <polhode/schemes/lie_euler.hpp>
#include <polhode/schemes/lie_heun.hpp>
#include <polhode/schemes/lie_trotter.hpp>
#include <polhode/schemes/magnus.hpp>
#include <polhode/schemes/milstein.hpp>
#include <polhode/schemes/milstein_no_area.hpp>
#include <polhode/schemes/strang.hpp>
#include <polhode/schemes/strang_weak2.hpp>
#include <polhode/systems/rigid_body.hpp>

#include "registry/bind.hpp"
#include "registry/systems.hpp"

namespace polhode {

using all_schemes = scheme_list<euler_maruyama, heun, heun_projected, milstein, milstein_no_area, implicit_midpoint,
                                lie_euler, lie_heun, cayley_heun, magnus, lie_trotter, strang, strang_weak2>;

subject bind_rigid_body(const report::scene& scene) {
  return bind(
      scene,
      [](const report::scene& s) {
        std::vector<rigid_body::column> vectors;
        for (const auto& v : s.sigma) vectors.push_back({v});
        return rigid_body(s.inertia, s.theta, rigid_body::from_vectors(vectors));
      },
      all_schemes{});
}

}  // namespace polhode
