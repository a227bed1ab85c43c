// SPDX-License-Identifier: Apache-2.0
#include "statistics/noise/path_audit.hpp"

#include <algorithm>
#include <bit>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <numbers>

namespace polhode {
namespace {

constexpr double same_hash = 0x1p-64;

template <class Real>
auto bits(Real x) {
  if constexpr (sizeof(Real) == 4)
    return std::bit_cast<std::uint32_t>(x);
  else
    return std::bit_cast<std::uint64_t>(x);
}

}  // namespace

template <class Real>
std::uint64_t path_audit::key_of(const Real* first, int steps, int rows, int channels, int stride) {
  std::size_t key = 0;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < channels; ++k)
      boost::hash_combine(key, bits(first[(static_cast<std::ptrdiff_t>(i) * rows + k) * stride]));
  return key;
}

template <class Real>
void path_audit::add_starts(const Real* z, int steps, int rows, int channels) {
  const int kept = std::min(steps, start_steps);
  numbers_ = kept * channels;
  for (int lane = 0; lane < lanes; ++lane) starts_.push_back(key_of(z + lane, kept, rows, channels, lanes));
}

template void path_audit::add_starts(const double*, int, int, int);
template void path_audit::add_starts(const float*, int, int, int);

void path_audit::add_start(const double* z, int steps, int rows, int channels) {
  const int kept = std::min(steps, start_steps);
  numbers_ = kept * channels;
  starts_.push_back(key_of(z, kept, rows, channels, 1));
}

void path_audit::add_products(const row& z) {
  if (products_.size() == 0) products_.setZero(lanes, lanes);
  for (Eigen::Index k = 0; k < lanes; ++k) products_.col(k).tail(lanes - k) += z[k] * z.matrix().tail(lanes - k);
}

void path_audit::merge(const path_audit& o) {
  if (!o.starts_.empty()) numbers_ = starts_.empty() ? o.numbers_ : std::min(numbers_, o.numbers_);
  starts_.insert(starts_.end(), o.starts_.begin(), o.starts_.end());
  if (products_.size() == 0)
    products_ = o.products_;
  else if (o.products_.size() > 0)
    products_ += o.products_;
}

double path_audit::probability_of_repeats() const {
  auto sorted = starts_;
  std::ranges::sort(sorted);
  if (std::ranges::adjacent_find(sorted) == sorted.end()) return 1;
  const auto n = static_cast<double>(starts_.size());
  return std::min(1.0, n * (n - 1) / 2 * (std::pow(same_number, numbers_) + same_hash));
}

double path_audit::probability_of_products() const {
  if (products_.size() == 0) return 1;
  double largest = 0;
  for (Eigen::Index b = 0; b < lanes; ++b)
    for (Eigen::Index a = b + 1; a < lanes; ++a)
      if (products_(b, b) > 0) largest = std::max(largest, std::fabs(products_(a, b)) / std::sqrt(products_(b, b)));
  constexpr int pairs = lanes * (lanes - 1) / 2;
  return std::min(1.0, pairs * std::erfc(largest / std::numbers::sqrt2));
}

}  // namespace polhode
