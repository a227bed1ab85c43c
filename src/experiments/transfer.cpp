#include "experiments/transfer.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "ensemble/basis_sums.hpp"
#include "ensemble/dense_algebra.hpp"
#include "experiments/point_block.hpp"
#include "experiments/vectors.hpp"

namespace polhode {
namespace {

constexpr double widest = 0.8;  // of log(radius), to either side

/// Calls use(first point, lanes in use, nodes, states of these nodes [node][component][lane]) for all points and nodes.
template <class Use>
void map_points(const kernel& k, const points_in_space& points, const noise_nodes& noise, const Use& use) {
  constexpr int chunk = 32, block = 3 * block_lanes;
  const auto table = k.share(noise.path());
  const int nodes = static_cast<int>(noise.weight.size()), count = static_cast<int>(points.rows());
  std::vector<double> start(block), mapped(static_cast<std::size_t>(block) * chunk);
  for (int first = 0; first < count; first += block_lanes) {
    load_block(points, first, start.data());
    for (int node = 0; node < nodes; node += chunk) {
      const int n = std::min(chunk, nodes - node);
      for (int i = 0; i < n; ++i) {
        const std::span state(mapped.data() + i * block, block);
        std::ranges::copy(start, state.begin());
        k.advance(state, table, node + i, 1);
      }
      use(first, lanes_in_use(points, first),
          std::span(noise.weight).subspan(static_cast<std::size_t>(node), static_cast<std::size_t>(n)), mapped.data());
    }
  }
}

/// Values of T B_j at the points of the basis.
Eigen::MatrixXd mapped_basis(const kernel& k, const shell_basis& basis, const noise_nodes& noise) {
  const int size = basis.size();
  Eigen::MatrixXd values(basis.points().rows(), size);
  std::vector<double> sums(static_cast<std::size_t>(size) * block_lanes);
  int done = 0;
  map_points(k, basis.points(), noise,
             [&](int first, int lanes, std::span<const double> weights, const double* states) {
               if (done == 0) std::ranges::fill(sums, 0.0);
               add_basis({basis.degree(), basis.radial(), basis.middle(), basis.half(), basis.recurrence().data(),
                          static_cast<int>(weights.size()), weights.data(), states, sums.data()});
               done += static_cast<int>(weights.size());
               if (done < static_cast<int>(noise.weight.size())) return;
               done = 0;
               for (int lane = 0; lane < lanes; ++lane)
                 for (int j = 0; j < size; ++j)
                   values(first + lane, j) =
                       sums[static_cast<std::size_t>((lane / sum_lanes * size + j) * sum_lanes + lane % sum_lanes)];
             });
  return values;
}

/// Calls use(point, weight, log(|Pi after a step| / |Pi|)) for every point and node.
template <class Use>
void map_radii(const kernel& k, const points_in_space& points, const noise_nodes& noise, const Use& use) {
  const Eigen::VectorXd radii = points.rowwise().norm();
  map_points(k, points, noise, [&](int first, int lanes, std::span<const double> weights, const double* states) {
    for (std::size_t i = 0; i < weights.size(); ++i)
      for (int lane = 0; lane < lanes; ++lane) {
        const double* at = states + 3 * block_lanes * static_cast<int>(i) + lane;
        const double now = std::hypot(at[0], at[block_lanes], at[2 * block_lanes]);
        use(first + lane, weights[i], std::log(now / radii[first + lane]));
      }
  });
}

/// How log |Pi| changes in one step from the sphere: the extremes of its mean, the largest variance.
struct radial_motion {
  double least_mean, largest_mean, variance;
};

radial_motion motion_of(const kernel& k, double radius, const noise_nodes& noise) {
  const points_in_space points = radius * sphere_quadrature(6).points;
  Eigen::ArrayXd mean = Eigen::ArrayXd::Zero(points.rows()), square = mean;
  map_radii(k, points, noise, [&](int point, double weight, double change) {
    mean[point] += weight * change;
    square[point] += weight * change * change;
  });
  return {mean.minCoeff(), mean.maxCoeff(), std::max(0.0, (square - mean.square()).maxCoeff())};
}

/// Wide enough for the radius of a path.
shell shell_around(const kernel& k, double radius, const noise_nodes& noise, std::int64_t steps, double deviations) {
  const auto motion = motion_of(k, radius, noise);
  const auto n = static_cast<double>(steps);
  const double spread = deviations * std::sqrt(n * motion.variance);
  const auto width = [&](double drift) { return std::clamp(n * drift + spread, 1e-3, widest); };
  return {radius * std::exp(-width(-motion.least_mean)), radius * std::exp(width(motion.largest_mean))};
}

shell shell_of(const kernel& k, const subject& s, const noise_nodes& noise, std::int64_t steps,
               const basis_rule& rule) {
  const double c = length(s.scene.momentum);
  return rule.radial == 1 ? shell{c, c} : shell_around(k, c, noise, steps, rule.deviations);
}

transfer_operator transfer_on(const kernel& k, shell_basis basis, const noise_nodes& noise) {
  transfer_operator out{std::move(basis), {}};
  out.matrix = out.basis.coefficients(mapped_basis(k, out.basis, noise));
  if (!out.matrix.col(0).hasNaN()) out.matrix.col(0) = Eigen::VectorXd::Unit(out.matrix.rows(), 0);  // T 1 = 1
  return out;
}

}  // namespace

std::optional<sphere_problem> sphere_problem_of(const subject& s) {
  if (s.scene.system != "rigid_body" || s.model->dimension() != 3) return std::nullopt;
  sphere_problem out{s.scene.inertia, s.scene.theta, length(s.scene.momentum), Eigen::Matrix3d::Zero()};
  for (const auto& v : s.scene.sigma) {
    const Eigen::Map<const Eigen::Vector3d> e(v.data());
    out.covariance += e * e.transpose();
  }
  return out;
}

sphere_problem with_more_noise(sphere_problem p, double share) {
  p.covariance *= (1 + share) * (1 + share);
  return p;
}

sphere_problem with_more_dissipation(sphere_problem p, double share) {
  p.theta *= 1 + share;
  return p;
}

Eigen::RowVectorXd transfer_operator::law_after(const Eigen::Vector3d& start, std::int64_t steps) const {
  Eigen::RowVectorXd law = basis.at(start);
  Eigen::MatrixXd power = matrix;
  for (; steps > matrix.rows(); steps /= 2) {  // squaring costs less than so many steps
    if (steps % 2 == 1) law *= power;
    Eigen::MatrixXd square = Eigen::MatrixXd::Zero(power.rows(), power.cols());
    add_product(power, power, square);
    power.swap(square);
  }
  for (; steps > 0; --steps) law *= power;
  return law;
}

// law (T - 1) = 0 with T 1 = 1: the first column is empty, and the first component is given.
Eigen::RowVectorXd invariant_law(const Eigen::MatrixXd& matrix, double first) {
  const auto n = matrix.rows() - 1;
  const Eigen::MatrixXd rest = matrix.bottomRightCorner(n, n) - Eigen::MatrixXd::Identity(n, n);
  Eigen::RowVectorXd law(n + 1);
  law << first, solve_from_left(rest, -first * matrix.row(0).tail(n));
  return law;
}

Eigen::RowVectorXd transfer_operator::stationary_law() const {
  return invariant_law(matrix, basis.at(Eigen::Vector3d::UnitZ() * basis.middle())[0]);
}

transfer_operator make_transfer(const subject& s, const scheme_entry& scheme, double dt, std::int64_t steps,
                                const transfer_rule& rule) {
  const auto stepper = scheme.make(dt);
  const auto noise = nodes_of(*s.model, scheme.needs_areas, dt, rule.noise);
  const shell around = shell_of(*stepper, s, noise, steps, rule.basis);
  return transfer_on(*stepper, shell_basis(rule.basis.degree, rule.basis.radial, around), noise);
}

Eigen::VectorXd change_by_far_noise(const subject& s, const scheme_entry& scheme, double dt, std::int64_t steps,
                                    const std::function<Eigen::VectorXd(const transfer_operator&)>& ask) {
  constexpr noise_rule near{8, 2};
  const basis_rule rule = scheme.info.casimir.exact ? basis_rule{10, 1, 0} : basis_rule{6, 4, 6};
  const auto stepper = scheme.make(dt);
  const auto noise = nodes_of(*s.model, scheme.needs_areas, dt, near);
  const shell_basis basis(rule.degree, rule.radial, shell_of(*stepper, s, noise, steps, rule));
  const auto far = far_nodes_of(*s.model, scheme.needs_areas, dt);
  return (ask(transfer_on(*stepper, basis, far)) - ask(transfer_on(*stepper, basis, noise))).cwiseAbs();
}

double taken_back(const subject& s, const scheme_entry& scheme, double dt, std::int64_t steps,
                  const transfer_rule& rule) {
  if (rule.basis.radial == 1) return 0;
  constexpr int radii = 5, powers = 12;
  const auto stepper = scheme.make(dt);
  const auto noise = nodes_of(*s.model, scheme.needs_areas, dt, rule.noise);
  const double c = length(s.scene.momentum), n = static_cast<double>(steps);
  const shell around = shell_of(*stepper, s, noise, steps, rule.basis);
  const double middle = (around.least + around.greatest) / 2, half = (around.greatest - around.least) / 2;
  const double least = std::max(middle - most_outside * half, around.least / 4), most = middle + most_outside * half;
  const auto directions = sphere_quadrature(6).points;
  points_in_space points(directions.rows() * radii, 3);
  for (int i = 0; i < radii; ++i)
    points.middleRows(i * directions.rows(), directions.rows()) =
        (least + (most - least) * i / (radii - 1)) * directions;
  const double unit = 1 / std::sqrt(n * std::max(motion_of(*stepper, c, noise).variance, 1e-300));
  Eigen::ArrayXXd up = Eigen::ArrayXXd::Zero(points.rows(), powers), down = up;
  map_radii(*stepper, points, noise, [&](int point, double weight, double change) {
    const double factor = std::exp(unit * change);
    for (int k = 0; k < powers; ++k) {
      up(point, k) += weight * std::pow(factor, k + 1);
      down(point, k) += weight * std::pow(factor, -k - 1);
    }
  });
  const auto bound = [&](const Eigen::ArrayXXd& mean, double far) {
    double out = 1;
    for (int k = 0; k < powers; ++k)
      out = std::min(out, std::exp(n * std::max(0.0, std::log(mean.col(k).maxCoeff())) - (k + 1) * unit * far));
    return out;
  };
  return std::min(1.0, bound(up, std::log(most / c)) + bound(down, std::log(c / least)));
}

}  // namespace polhode
