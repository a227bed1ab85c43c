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

/// n(lane) gives the three components of sigma dW.
template <class Noise>
void heun_step(arrays& p, Noise n, double dt) {
  const auto slope = [dt](double x, double y, double z, double n1, double n2, double n3, double out[3]) {
    const double w1 = i1 * x, w2 = i2 * y, w3 = i3 * z;
    const double a = dt * (w1 + theta * (y * w3 - z * w2)) + n1;
    const double b = dt * (w2 + theta * (z * w1 - x * w3)) + n2;
    const double c = dt * (w3 + theta * (x * w2 - y * w1)) + n3;
    out[0] = y * c - z * b;
    out[1] = z * a - x * c;
    out[2] = x * b - y * a;
  };
#pragma omp simd
  for (int k = 0; k < soa_paths; ++k) {
    const double x = p.x[k], y = p.y[k], z = p.z[k];
    double f[3], g[3];
    slope(x, y, z, n.x(k), n.y(k), n.z(k), f);
    slope(x + f[0], y + f[1], z + f[2], n.x(k), n.y(k), n.z(k), g);
    p.x[k] = x + 0.5 * (f[0] + g[0]);
    p.y[k] = y + 0.5 * (f[1] + g[1]);
    p.z[k] = z + 0.5 * (f[2] + g[2]);
  }
}

struct one_for_all {
  double a, b, c;
  double x(int) const { return a; }
  double y(int) const { return b; }
  double z(int) const { return c; }
};

struct one_each {
  const arrays& n;
  double x(int k) const { return n.x[k]; }
  double y(int k) const { return n.y[k]; }
  double z(int k) const { return n.z[k]; }
};

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
  for (int i = 0; i < steps; ++i)
    if (noise == ensemble_noise::independent) {
      draw(n, sigma * std::sqrt(dt));
      heun_step(p, one_each{n}, dt);
    } else if (noise == ensemble_noise::common) {
      const auto* w = common.data() + 3 * i;
      heun_step(p, one_for_all{sigma * w[0], sigma * w[1], sigma * w[2]}, dt);
    } else {
      heun_step(p, one_for_all{0, 0, 0}, dt);
    }
  std::vector<double> out;
  for (const auto* row : {&p.x, &p.y, &p.z}) out.insert(out.end(), row->begin(), row->end());
  return out;
}

}  // namespace polhode::bench
