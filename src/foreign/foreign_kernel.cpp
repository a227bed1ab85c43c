// SPDX-License-Identifier: Apache-2.0
#include "foreign/foreign_kernel.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include <polhode/increment.hpp>

#include "platform/work_counters.hpp"

namespace polhode::foreign {
namespace {

constexpr int chunk = 16;  // steps of a common noise that are spread over a block at a time

/// Steppers that wait for the next thread which needs one.
class stepper_pool {
 public:
  stepper_pool(std::shared_ptr<foreign_scheme> scheme, problem p)
      : scheme_(std::move(scheme)), problem_(std::move(p)) {}

  const problem& on() const { return problem_; }
  const foreign_scheme& scheme() const { return *scheme_; }

  /// A failure is kept by the scheme, and the states are NaN.
  void advance(const batch& b) {
    count_path_steps(static_cast<std::uint64_t>(b.steps) * static_cast<std::uint64_t>(b.paths),
                     scheme_->about().name.c_str());
    if (!scheme_->failure()) try {
        const auto turn = scheme_->turn();
        auto one = take();
        one->advance(b);
        give_back(std::move(one));
        return;
      } catch (const failure& f) {
        scheme_->fail(f.what());
      }
    std::fill_n(b.states, problem_.components * b.paths, std::numeric_limits<double>::quiet_NaN());
  }

 private:
  std::unique_ptr<stepper> take() {
    {
      const std::lock_guard lock(guard_);
      if (!free_.empty()) {
        auto one = std::move(free_.back());
        free_.pop_back();
        return one;
      }
    }
    return scheme_->source().open(problem_);
  }
  void give_back(std::unique_ptr<stepper> one) {
    const std::lock_guard lock(guard_);
    free_.push_back(std::move(one));
  }

  std::shared_ptr<foreign_scheme> scheme_;
  problem problem_;
  std::mutex guard_;
  std::vector<std::unique_ptr<stepper>> free_;
};

/// Increments as an integrator takes them: doubles, or seeds that are a function of the increments, so that equal noise
/// stays equal noise and another noise another.
class taken_noise {
 public:
  taken_noise(const increment_view& view, const problem& p, noise_access takes) {
    if (takes == noise_access::own_numbers) seed(view, p.channels);
    if (takes == noise_access::own_numbers || view.silent()) return;
    if (view.singles.empty()) {
      dw_ = view.dw;
    } else {
      scaled_.assign(view.singles.begin(), view.singles.end());
      for (double& x : scaled_) x *= view.scale;
      dw_ = scaled_;
    }
    if (takes == noise_access::areas) area_ = view.area;
  }
  batch on(double* states, int steps) const {
    const auto at = [](auto all) { return all.empty() ? nullptr : all.data(); };
    return {block_lanes, steps, states, at(dw_), at(area_), seeds_.empty() ? nullptr : seeds_.data()};
  }

 private:
  /// Finaliser of SplitMix64 (Steele, Lea, Flood 2014).
  static std::uint64_t mixed(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
  }
  void seed(const increment_view& view, int channels) {
    seeds_.assign(static_cast<std::size_t>(view.steps * block_lanes), 0);
    if (view.silent()) return;
    for (std::size_t i = 0; i < seeds_.size(); ++i)
      for (int c = 0; c < channels; ++c) {
        const auto at =
            (i / block_lanes * static_cast<std::size_t>(channels) + static_cast<std::size_t>(c)) * block_lanes +
            i % block_lanes;
        const auto bits = view.singles.empty() ? std::bit_cast<std::uint64_t>(view.dw[at])
                                               : std::bit_cast<std::uint32_t>(view.singles[at]);
        seeds_[i] = mixed(seeds_[i] + bits + 0x9E3779B97F4A7C15u);
      }
  }
  std::vector<double> scaled_;
  std::span<const double> dw_, area_;
  std::vector<std::uint64_t> seeds_;
};

void advance(stepper_pool& pool, std::span<double> states, const increment_view& view) {
  if (view.steps == 0) return;
  const taken_noise noise(view, pool.on(), pool.scheme().about().takes);
  pool.advance(noise.on(states.data(), view.steps));
}

class foreign_kernel final : public kernel {
 public:
  foreign_kernel(std::shared_ptr<foreign_scheme> scheme, const problem& p) : pool_(std::move(scheme), p) {}

  double dt() const override { return pool_.on().dt; }
  void advance(std::span<double> states, const increment_view& view, piece) const override {
    foreign::advance(pool_, states, view);
  }

  /// The increments and areas of each step.
  shared_steps share(const increment_view& path) const override {
    const auto steps = static_cast<std::size_t>(path.steps);
    shared_steps out{channels() + pairs(), std::vector<double>(steps * (channels() + pairs()))};
    for (std::size_t i = 0; i < steps; ++i) {
      double* row = out.table.data() + i * out.words;
      if (!path.dw.empty()) std::copy_n(path.dw.data() + i * channels(), channels(), row);
      if (!path.area.empty()) std::copy_n(path.area.data() + i * pairs(), pairs(), row + channels());
    }
    return out;
  }
  void advance(std::span<double> states, const shared_steps& noise, std::int64_t first, std::int64_t steps,
               piece) const override {
    std::vector<double> dw, area;
    for (std::int64_t done = 0; done < steps; done += chunk) {
      const int now = static_cast<int>(std::min<std::int64_t>(chunk, steps - done));
      spread(noise, first + done, now, 0, channels(), dw);
      spread(noise, first + done, now, channels(), pairs(), area);
      foreign::advance(pool_, states, {now, dw, area});
    }
  }
  void finish(std::span<double>) const override {}

 private:
  std::size_t channels() const { return static_cast<std::size_t>(pool_.on().channels); }
  std::size_t pairs() const { return static_cast<std::size_t>(pairs_among(pool_.on().channels)); }

  /// `count` words of each row, from `from` on, to every lane.
  static void spread(const shared_steps& noise, std::int64_t first, int steps, std::size_t from, std::size_t count,
                     std::vector<double>& out) {
    out.resize(static_cast<std::size_t>(steps) * count * block_lanes);
    auto to = out.begin();
    for (int i = 0; i < steps; ++i)
      for (std::size_t k = 0; k < count; ++k)
        to = std::fill_n(to, block_lanes, noise.table[static_cast<std::size_t>(first + i) * noise.words + from + k]);
  }

  mutable stepper_pool pool_;
};

class foreign_tangents final : public tangent_kernel {
 public:
  foreign_tangents(std::shared_ptr<foreign_scheme> scheme, const problem& p) : pool_(std::move(scheme), p) {}

  double dt() const override { return pool_.on().dt; }
  void advance(std::span<double> states, std::span<double> tangents, const increment_view& view) const override {
    const auto size = states.size();
    const std::vector<double> start(states.begin(), states.end());
    for (std::size_t t = 0; t < tangent_vectors; ++t) differentiate(start, tangents.subspan(t * size, size), view);
    foreign::advance(pool_, states, view);
  }

 private:
  void differentiate(const std::vector<double>& start, std::span<double> tangent, const increment_view& view) const {
    const auto unit = units_of(start, tangent);
    std::vector<double> slope(start.size());
    for (int k = 1; k <= 3; ++k) {
      auto ahead = start, behind = start;
      for (std::size_t i = 0; i < start.size(); ++i) {
        ahead[i] += k * unit[i % block_lanes] * tangent[i];
        behind[i] -= k * unit[i % block_lanes] * tangent[i];
      }
      foreign::advance(pool_, ahead, view);
      foreign::advance(pool_, behind, view);
      for (std::size_t i = 0; i < start.size(); ++i)
        slope[i] += weights[static_cast<std::size_t>(k - 1)] * (ahead[i] - behind[i]) / unit[i % block_lanes];
    }
    std::ranges::copy(slope, tangent.begin());
  }

  /// Of the differences over 2, 4 and 6 units: exact up to the sixth derivative.
  static constexpr std::array weights{45.0 / 60, -9.0 / 60, 1.0 / 60};

  /// By lane: 2^-9 |mu| / |tangent|, where the seventh derivative and rounding are about as small.
  static std::vector<double> units_of(const std::vector<double>& start, std::span<const double> tangent) {
    std::vector<double> of_state(block_lanes), of_tangent(block_lanes);
    for (std::size_t i = 0; i < start.size(); ++i) {
      of_state[i % block_lanes] += start[i] * start[i];
      of_tangent[i % block_lanes] += tangent[i] * tangent[i];
    }
    for (std::size_t lane = 0; lane < of_state.size(); ++lane)
      of_state[lane] = of_tangent[lane] > 0 ? 0x1p-9 * std::sqrt(of_state[lane] / of_tangent[lane]) : 1;
    return of_state;
  }

  mutable stepper_pool pool_;
};

}  // namespace

std::unique_ptr<kernel> make_kernel(std::shared_ptr<foreign_scheme> scheme, const problem& p) {
  return std::make_unique<foreign_kernel>(std::move(scheme), p);
}

std::unique_ptr<tangent_kernel> make_tangent_kernel(std::shared_ptr<foreign_scheme> scheme, const problem& p) {
  return std::make_unique<foreign_tangents>(std::move(scheme), p);
}

}  // namespace polhode::foreign
