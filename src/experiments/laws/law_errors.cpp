// SPDX-License-Identifier: Apache-2.0
#include "experiments/laws/law_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "algebra/dense_algebra.hpp"
#include "experiments/laws/transfer_report.hpp"
#include "sphere/stationary.hpp"

namespace polhode {
namespace {

constexpr std::array names{"energy", "pi1", "pi2", "pi3", "pi1^2", "pi2^2", "pi3^2", "exp(pi3)", "casimir"};

Eigen::Vector3d start_of(const subject& s) { return Eigen::Map<const Eigen::Vector3d>(s.scene.momentum.data()); }

Eigen::MatrixXd power_of(Eigen::MatrixXd base, std::int64_t exponent) {
  Eigen::MatrixXd out;
  for (;; exponent /= 2) {
    if (exponent % 2 == 1) {
      if (out.size() == 0) {
        out = base;
      } else {
        Eigen::MatrixXd product = Eigen::MatrixXd::Zero(base.rows(), base.cols());
        add_product(out, base, product);
        out.swap(product);
      }
    }
    if (exponent <= 1) return out;
    Eigen::MatrixXd square = Eigen::MatrixXd::Zero(base.rows(), base.cols());
    add_product(base, base, square);
    base.swap(square);
  }
}

Eigen::MatrixXd coefficients_on(const shell_basis& basis, std::span<const sphere_function> functions) {
  const auto& points = basis.points();
  Eigen::MatrixXd values(points.rows(), static_cast<Eigen::Index>(functions.size()));
  for (Eigen::Index k = 0; k < values.cols(); ++k)
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      values(i, k) = functions[static_cast<std::size_t>(k)](points.row(i).transpose());
  return basis.coefficients(values);
}

/// Numbers of steps: every one, of many as many as are looked at, and the last. Multiples of `finer` only.
std::vector<std::int64_t> looked_at(std::int64_t steps, std::int64_t finer) {
  const std::int64_t coarse = std::max<std::int64_t>(1, steps / finer);
  const std::int64_t stride = (coarse + weak_law::most_times - 1) / weak_law::most_times;
  std::vector<std::int64_t> out;
  for (std::int64_t k = stride; k < coarse; k += stride) out.push_back(k * finer);
  out.push_back(steps);
  return out;
}

/// Answers in units of the observables' sizes, repeated for every time.
law_error in_sizes(const transfer_answer& found, const Eigen::VectorXd& scale, std::vector<double> times) {
  return {(found.error.array() / scale.array()).matrix(), (found.uncertainty.array() / scale.array()).matrix(),
          std::move(times)};
}

}  // namespace

namespace {

void add_means(const Eigen::MatrixXd& matrix, Eigen::MatrixXd law, const Eigen::MatrixXd& coefficients,
               const std::vector<std::int64_t>& after, Eigen::MatrixXd& out) {
  const auto stride = after.front(), times = static_cast<std::int64_t>(after.size());
  constexpr double cheaper = 4;  // a number in a product of matrices, which waits for no memory, than in a law's next
  const auto bits = static_cast<std::uint64_t>(stride);
  const int products = static_cast<int>(std::bit_width(bits)) + std::popcount(bits) - 2;
  const bool in_strides =
      products * static_cast<double>(matrix.rows()) / cheaper < static_cast<double>((stride - 1) * times);
  const Eigen::MatrixXd far = in_strides ? power_of(matrix, stride) : Eigen::MatrixXd();
  Eigen::MatrixXd next_law(1, law.cols());
  const auto take = [&](const Eigen::MatrixXd& steps) {
    next_law.setZero();
    add_product(law, steps, next_law);
    law.swap(next_law);
  };
  std::int64_t done = 0;
  for (Eigen::Index t = 0; t < out.cols(); ++t) {
    const auto next = after[static_cast<std::size_t>(t)];
    if (in_strides && next - done == stride) {
      take(far);
      done = next;
    }
    for (; done < next; ++done) take(matrix);
    out.col(t) += (law * coefficients).transpose();
  }
}

}  // namespace

Eigen::MatrixXd means_after(const transfer_operator& op, const Eigen::Vector3d& start,
                            std::span<const sphere_function> functions, const std::vector<std::int64_t>& after) {
  const Eigen::MatrixXd coefficients = coefficients_on(op.basis, functions);
  const Eigen::RowVectorXd law = op.basis.at(start);
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(coefficients.cols(), static_cast<Eigen::Index>(after.size()));
  for (const auto& block : op.blocks)
    add_means(op.matrix(block, block), law(block), coefficients(block, Eigen::all), after, out);
  return out;
}

law_observables every_observable(const subject& s) {
  law_observables out;
  const auto& problem = *s.sphere();
  out.size.resize(names.size());
  for (const char* name : names) {
    out.functions.push_back(*named_observable(name, problem));
    out.size[static_cast<Eigen::Index>(out.names.size())] = size_on_sphere(out.functions.back(), problem.radius);
    out.names.emplace_back(name);
  }
  return out;
}

std::vector<observable_error> law_error::worst_in_time(const law_observables& all) const {
  std::vector<observable_error> out;
  for (Eigen::Index i = 0; i < all.count(); ++i) {
    observable_error worst{all.names[static_cast<std::size_t>(i)], 0, 0, 0};
    for (std::size_t t = 0; t < times.size(); ++t) {
      const auto k = i + all.count() * static_cast<Eigen::Index>(t);
      const double value = std::fabs(error[k]);
      if (t == 0 || !(value + uncertainty[k] <= worst.bound())) {
        worst.value = value;
        worst.uncertainty = uncertainty[k];
        worst.time = times[t];
      }
      if (!std::isfinite(value)) break;
    }
    out.push_back(worst);
  }
  return out;
}

weak_law::weak_law(const subject& s, double horizon, double accuracy, operator_store* kept)
    : subject_(s),
      horizon_(horizon),
      observables_(every_observable(s)),
      start_(start_of(s)),
      truth_(expectations(*s.sphere(), observables_.functions, observables_.size, start_, horizon, accuracy)),
      kept_(kept) {}

law_error weak_law::error(const scheme_entry& scheme, double dt, double tolerance, std::int64_t finer) const {
  const std::int64_t steps = std::max<std::int64_t>(1, std::llround(horizon_ / dt));
  const auto after = looked_at(steps, finer);
  const auto n = observables_.count(), count = static_cast<Eigen::Index>(after.size());
  std::vector<double> times;
  Eigen::VectorXd exact(n * count);
  for (const auto k : after) {
    exact.segment(n * static_cast<Eigen::Index>(times.size()), n) =
        truth_.at(horizon_ * static_cast<double>(k) / static_cast<double>(steps));
    times.push_back(horizon_ * static_cast<double>(k) / static_cast<double>(steps));
  }
  const Eigen::VectorXd scale = observables_.size.replicate(count, 1);
  transfer_question q{[&](const transfer_operator& op) -> Eigen::VectorXd {
                        return means_after(op, start_, observables_.functions, after).reshaped();
                      },
                      {exact, scale, tolerance}};
  q.name = fmt::format("after {} steps, by {}", steps, finer);
  auto found = refine(subject_, scheme, dt, steps, q, kept_);
  found.uncertainty += truth_.uncertainty().replicate(count, 1);
  return in_sizes(found, scale, std::move(times));
}

equilibrium_law::equilibrium_law(const subject& s, double accuracy, operator_store* kept)
    : subject_(s), observables_(every_observable(s)), kept_(kept) {
  const auto problem = *s.sphere();
  const auto law = stationary(problem, accuracy);
  mean_.resize(observables_.count());
  uncertainty_.resize(observables_.count());
  for (Eigen::Index i = 0; i < mean_.size(); ++i) {
    const auto one = polhode::mean(problem, law, observables_.functions[static_cast<std::size_t>(i)]);
    if (!one.value) {
      reason_ = one.reason;
      return;
    }
    mean_[i] = *one.value;
    uncertainty_[i] = one.uncertainty;
  }
}

law_error equilibrium_law::error(const scheme_entry& scheme, double dt, double tolerance) const {
  transfer_question q{[&](const transfer_operator& op) -> Eigen::VectorXd {
                        return (op.stationary_law() * coefficients_on(op.basis, observables_.functions)).transpose();
                      },
                      {mean_, observables_.size, tolerance}};
  q.name = "at equilibrium";
  auto found = refine(subject_, scheme, dt, 1, q, kept_);
  found.uncertainty += uncertainty_;
  return in_sizes(found, observables_.size, {0.0});
}

}  // namespace polhode
