// SPDX-License-Identifier: Apache-2.0
// What a good programmer writes in a day: a structure of arrays, a loop for the compiler to vectorise, a fast library's
// normals.
#include <array>
#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <cmath>

#include "bench/yardsticks.hpp"

namespace polhode::bench {
namespace {

constexpr double theta = 0.5, sigma = 0.5, i1 = 1.0, i2 = 1.0 / 2, i3 = 1.0 / 3;

struct arrays {
  alignas(64) std::array<double, soa_paths> x, y, z;
};

struct triple {
  double x, y, z;
};

triple cross(triple a, triple b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

/// Pi x (dt (Omega + theta Pi x Omega) + noise).
triple slope(triple p, triple noise, double dt) {
  const triple w{i1 * p.x, i2 * p.y, i3 * p.z}, d = cross(p, w);
  return cross(
      p, {dt * (w.x + theta * d.x) + noise.x, dt * (w.y + theta * d.y) + noise.y, dt * (w.z + theta * d.z) + noise.z});
}

triple heun_step(triple p, triple noise, double dt) {
  const triple f = slope(p, noise, dt), g = slope({p.x + f.x, p.y + f.y, p.z + f.z}, noise, dt);
  return {p.x + 0.5 * (f.x + g.x), p.y + 0.5 * (f.y + g.y), p.z + 0.5 * (f.z + g.z)};
}

/// noise(path) gives sigma dW.
template <class Noise>
void advance(arrays& p, Noise noise, double dt) {
  double *x = p.x.data(), *y = p.y.data(), *z = p.z.data();
#pragma omp simd
  for (int k = 0; k < soa_paths; ++k) {
    const triple next = heun_step({x[k], y[k], z[k]}, noise(k), dt);
    x[k] = next.x;
    y[k] = next.y;
    z[k] = next.z;
  }
}

void draw(arrays& n, double scale) {
  static boost::random::mt19937_64 generator(1);
  boost::random::normal_distribution<double> normal(0, scale);
  for (auto* row : {&n.x, &n.y, &n.z})
    for (double& value : *row) value = normal(generator);
}

}  // namespace

std::vector<double> soa_ziggurat_heun(ensemble_noise noise, momentum start, std::span<const double> common, int steps,
                                      double dt) {
  arrays p, n;
  p.x.fill(start[0]);
  p.y.fill(start[1]);
  p.z.fill(start[2]);
  for (int i = 0; i < steps; ++i) {
    if (noise == ensemble_noise::independent) {
      draw(n, sigma * std::sqrt(dt));
      advance(
          p,
          [x = n.x.data(), y = n.y.data(), z = n.z.data()](int k) {
            return triple{x[k], y[k], z[k]};
          },
          dt);
    } else {
      triple w{0, 0, 0};
      if (noise == ensemble_noise::common)
        w = {sigma * common[3 * i], sigma * common[3 * i + 1], sigma * common[3 * i + 2]};
      advance(
          p, [w](int) { return w; }, dt);
    }
  }
  std::vector<double> out;
  for (const auto* row : {&p.x, &p.y, &p.z}) out.insert(out.end(), row->begin(), row->end());
  return out;
}

}  // namespace polhode::bench
