// SPDX-License-Identifier: Apache-2.0
#include "experiments/lyapunov/tangent_runs.hpp"

#include <array>
#include <cmath>
#include <polhode/lie/so3.hpp>
#include <polhode/systems/constant_noise.hpp>

#include "ensemble/kernel_of.hpp"
#include "ensemble/noise/paths.hpp"
#include "ensemble/tangent_controls.hpp"
#include "ensemble/uniform_start.hpp"
#include "problem/vectors.hpp"

namespace polhode {
namespace {

constexpr int chunk = 16;  // steps between two looks at the lengths of the tangents
constexpr std::size_t row = block_lanes, vector_size = 3 * row;
constexpr auto width = pack::size();

/// Two tangents at each state, by address.
std::vector<double> random_tangents(std::uint64_t seed, std::uint64_t first_path) {
  std::vector<double> out;
  for (std::uint64_t t = 1; t <= tangent_vectors; ++t)
    for (std::uint64_t k = 0; k < 3; ++k)
      for (std::uint64_t lane = 0; lane < block_lanes; ++lane)
        out.push_back(normals<3>({seed, noise_kind::initial_state, first_path + lane, t})[static_cast<int>(k)]);
  return out;
}

vec<pack, 3> without(const vec<pack, 3>& direction, const vec<pack, 3>& v) {
  return v - pack(dot(direction, v) / dot(direction, direction)) * direction;
}

void add(const pack& x, double* to) { pack(pack(to, stdx::element_aligned) + x).copy_to(to, stdx::element_aligned); }

std::array<double, 9> by_rows(const Eigen::Matrix3d& m) {
  std::array<double, 9> out;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) out[static_cast<std::size_t>(3 * i + k)] = m(i, k);
  return out;
}

/// A block of paths of one scheme.
class tangent_block {
 public:
  tangent_block(std::uint64_t seed, std::uint64_t first_path, double radius, const constant_noise<so3>& noise)
      : sigma_(by_rows(noise.sigma())),
        covariance_(by_rows(noise.sigma() * noise.sigma().transpose())),
        states_(uniform_states(seed, first_path, radius)),
        tangents_(random_tangents(seed, first_path)) {
    orthonormalise();
  }

  void forget(const tangent_kernel& k, const increment_view& noise) {
    k.advance(states_, tangents_, noise);
    orthonormalise();
  }
  void observe(const tangent_kernel& k, const increment_view& noise) {
    for (int i = 0; i < noise.steps; ++i) {
      const auto one = noise.part(i, 1);
      add_controls(one, k.dt());
      k.advance(states_, tangents_, one);
    }
    for (std::size_t lane = 0; lane < row; lane += width) {
      const auto [length, area] = orthonormalise(lane);
      add(logarithm(length), length_.data() + lane);
      add(logarithm(area), area_.data() + lane);
    }
  }
  void keep(double time, int first_path, growth& out) const {
    for (int lane = 0; lane < block_lanes; ++lane) {
      const auto at = static_cast<std::size_t>(lane);
      out.length[first_path + lane] = length_[at] / time;
      out.area[first_path + lane] = area_[at] / time;
      for (int i = 0; i < growth::controls; ++i)
        out.control(first_path + lane, i) = control_[static_cast<std::size_t>(i) * row + at] / time;
    }
  }

 private:
  struct grown {
    pack length, area;
  };
  /// Lengths and areas as they were. The radial part, which rounding puts in, is taken out: the flow keeps it, so that
  /// it would outgrow tangents that shrink.
  grown orthonormalise(std::size_t lane) {
    const auto x = load_lanes<pack, 3>(states_.data() + lane);
    auto v = without(x, load_lanes<pack, 3>(tangents_.data() + lane));
    auto w = without(x, load_lanes<pack, 3>(tangents_.data() + vector_size + lane));
    const pack first = square_root(dot(v, v));
    v = pack(1 / first) * v;
    w = w - dot(v, w) * v;
    const pack second = square_root(dot(w, w));
    store_lanes(v, tangents_.data() + lane);
    store_lanes(pack(1 / second) * w, tangents_.data() + vector_size + lane);
    return {first, first * second};
  }
  void orthonormalise() {
    for (std::size_t lane = 0; lane < row; lane += width) orthonormalise(lane);
  }

  void add_controls(const increment_view& one, double dt) {
    add_tangent_controls({states_.data(), tangents_.data(), one, dt, sigma_, covariance_, control_.data()});
  }

  std::array<double, 9> sigma_, covariance_;
  std::vector<double> states_, tangents_;
  std::array<double, row> length_{}, area_{};
  std::array<double, growth::controls * row> control_{};
};

}  // namespace

run_length run_length_of(double dt, double forgetting, double observed) {
  const auto whole_chunks = [&](double time) { return chunk * std::ceil(time / (dt * chunk)); };
  return {dt, whole_chunks(forgetting), whole_chunks(observed)};
}

void run_tangents(const context& c, const run_length& run, int block, std::span<const tangent_kernel* const> kernels,
                  bool with_areas, std::span<growth* const> out, noise_log* log) {
  const int first = block * block_lanes;
  const auto first_path = static_cast<std::uint64_t>(first);
  increment_buffer noise(*c.subject.model, chunk, with_areas, {c.generator, noise_quality::fast});
  std::vector<constant_noise<so3>::column> vectors;
  for (const auto& v : noise_vectors_of(c.subject.scene)) vectors.push_back({{v[0], v[1], v[2]}});
  const tangent_block start(c.seed, first_path, length(c.subject.scene.momentum),
                            constant_noise<so3>::from_vectors(vectors));
  std::vector<tangent_block> blocks(kernels.size(), start);
  const auto forgetting = static_cast<std::uint64_t>(run.forgetting),
             all = forgetting + static_cast<std::uint64_t>(run.observed);
  for (std::uint64_t step = 0; step < all; step += chunk) {
    const auto view = noise.fill(c.seed, first_path, step, chunk, run.dt);
    if (log) log->add(block, view, run.dt);
    for (std::size_t k = 0; k < kernels.size(); ++k)
      step < forgetting ? blocks[k].forget(*kernels[k], view) : blocks[k].observe(*kernels[k], view);
  }
  for (std::size_t k = 0; k < kernels.size(); ++k) blocks[k].keep(run.time(), first, *out[k]);
}

}  // namespace polhode
