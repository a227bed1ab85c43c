// SPDX-License-Identifier: Apache-2.0
#include "sphere/spectral_gap.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include "algebra/slowest_modes.hpp"
#include "algebra/sparse_blocks.hpp"
#include "sphere/averaged_gap.hpp"
#include "sphere/galerkin/raise_degree.hpp"
#include "sphere/harmonics/backward_operator.hpp"
#include "sphere/harmonics/harmonics.hpp"
#include "sphere/uniqueness.hpp"

namespace polhode {
namespace {

constexpr std::array gap_degrees{8, 12, 16, 24, 32, 48, 64, 96};
constexpr int most_unknowns_of_gap = 5000;  // unknowns in a block: seconds
constexpr double least_accuracy = 0.01;     // of the gap: less is no answer
constexpr double is_a_mode = 0.1;           // remainder of the slowest mode in the next degrees, over its rate
constexpr double certain_digit = 10;        // the gap over its rounding error
constexpr double faint = 100;               // needed degree from which averaging over circles is worth naming

/// The generator without the constant function, apart into its blocks; beyond: what it sends to the next two degrees.
struct relaxing_parts {
  std::vector<sparse_matrix> inside, beyond;
};

relaxing_parts parts_of(const sphere_problem& problem, int degree) {
  const int size = harmonic_count(degree);
  const sparse_matrix tall = tall_backward_operator(problem, degree).rightCols(size - 1);
  const sparse_matrix square = tall.middleRows(1, size - 1), rest = tall.bottomRows(tall.rows() - size);
  relaxing_parts parts;
  for (const index_set& block : connected_blocks(square)) {
    parts.inside.push_back(submatrix(square, block));
    parts.beyond.push_back(columns_of(rest, block));
  }
  return parts;
}

struct slowest_mode {
  std::size_t block = 0;
  std::complex<double> rate = -unbounded;
};

/// Of every block; and the mode of the last degree, where it oscillates too fast to be found near zero.
slowest_mode slowest_of(const relaxing_parts& parts, const slowest_mode& before) {
  slowest_mode least;
  const auto offer = [&](std::size_t block, std::complex<double> rate) {
    if (rate.real() > least.rate.real()) least = {block, rate};
  };
  for (std::size_t b = 0; b < parts.inside.size(); ++b) offer(b, slowest_rate(parts.inside[b]));
  const bool known = std::isfinite(before.rate.real()) && before.block < parts.inside.size();
  if (known && std::abs(least.rate - before.rate) > 0.1 * std::abs(before.rate))
    offer(before.block, eigenpair_near(parts.inside[before.block], before.rate).rate);
  return least;
}

/// For a refusal: no bar of it is known, so that it is no answer.
std::string averaged_in_words(const sphere_problem& problem) {
  if (!(needed_degree(problem) > faint)) return "";
  const auto averaged = averaged_gap(problem);
  if (!averaged) return "";
  return fmt::format(
      "; the limit for noise and dissipation that fade together, by averaging over circles of equal "
      "energy, is {:.4g} at this strength of noise",
      averaged->gap());
}

}  // namespace

reference_value spectral_gap(const sphere_problem& problem, double tolerance, int wanted) {
  if (!problem.has_noise()) return {.reason = "no noise: nothing relaxes in law"};
  if (conserves_a_component(problem)) return {.value = 0};
  if (const auto reason = no_unique_law(problem); !reason.empty()) return {.reason = reason};
  slowest_mode mode;
  const auto gap_at = [&](int degree) -> std::optional<projected_value> {
    const auto parts = parts_of(problem, degree);
    if (std::ranges::max(parts.inside, {}, [](const auto& part) { return part.rows(); }).rows() > most_unknowns_of_gap)
      return {};
    mode = slowest_of(parts, mode);
    const auto pair = eigenpair_near(parts.inside[mode.block], mode.rate);
    if (!std::isfinite(pair.rate.real())) return {};
    mode.rate = pair.rate;
    const double remainder =
        pair.condition * (parts.beyond[mode.block].cast<std::complex<double>>() * pair.right).norm();
    return projected_value{
        .value = -pair.rate.real(), .floor = pair.rounding, .resolved = remainder <= is_a_mode * std::abs(pair.rate)};
  };
  const accuracy asked{.absolute = tolerance, .relative = least_accuracy, .size = std::numeric_limits<double>::min()};
  auto gap = raise_degree(degrees_to_try(gap_degrees, wanted), asked, needed_degree(problem), gap_at, wanted);
  if (!gap.converged()) gap.reason += averaged_in_words(problem);
  if (gap.converged() && !(*gap.value > certain_digit * gap.uncertainty))
    gap.reason = fmt::format(
        "not converged: {:.1g} is within its rounding error; more than double precision would be needed", *gap.value);
  return gap;
}

}  // namespace polhode
