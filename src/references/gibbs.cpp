#include "references/gibbs.hpp"

#include <gsl/gsl_interp.h>

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <cmath>

namespace polhode {
namespace {

constexpr int panels = 600;

// Clusters points at both ends like s^4, which takes the edge off a logarithm or an inverse square root there.
double smoothstep(double s) { return s * s * (3 - 2 * s); }
double smoothstep_inverse(double y) { return 0.5 - std::sin(std::asin(1 - 2 * y) / 3); }
double clustered(double s) { return smoothstep(smoothstep(s)); }
double clustered_slope(double s) { return 36 * smoothstep(s) * smoothstep(1 - s) * s * (1 - s); }
double clustered_inverse(double y) { return smoothstep_inverse(smoothstep_inverse(y)); }

/// The orbits of energy h: their period and the orbit means of the squared components, ordered I[0] <= I[1] <= I[2].
struct level_set {
  double period;
  std::array<double, 3> square;
};

/// from: distances 2 h I_k - c^2 without sign, computed by the caller so that they do not cancel.
level_set orbits(const std::array<double, 3>& i, const std::array<double, 3>& from, bool round_last) {
  const int round = round_last ? 2 : 0, other = round_last ? 0 : 2;
  const double near = std::fabs(i[round] - i[1]), far = std::fabs(i[1] - i[other]), spread = std::fabs(i[2] - i[0]);
  const double m = std::clamp(far * from[round] / (near * from[other]), 0.0, 1 - 1e-16);
  const double rate = std::sqrt(near * from[other] / (i[0] * i[1] * i[2]));
  const double k = boost::math::ellint_1(std::sqrt(m)), e = boost::math::ellint_2(std::sqrt(m));
  const double sn2 = m > 1e-8 ? (k - e) / (m * k) : 0.5;
  level_set l{4 * k / rate, {}};
  l.square[round] = i[round] * from[other] / spread * (e / k);
  l.square[other] = i[other] * from[round] / spread * (1 - sn2);
  l.square[1] = i[1] * from[round] / near * sn2;
  return l;
}

}  // namespace

struct gibbs_law::piece {
  double low = 0, high = 0;     // energies
  std::vector<double> s, mass;  // cumulative probability at s, h = low + (high - low) clustered(s)
};

gibbs_law::~gibbs_law() = default;
gibbs_law::gibbs_law(gibbs_law&&) noexcept = default;

gibbs_law::gibbs_law(const std::array<double, 3>& inertia, double c, double beta) {
  std::array<int, 3> order{0, 1, 2};
  std::ranges::sort(order, [&](int a, int b) { return inertia[a] < inertia[b]; });
  std::array<double, 3> i{}, critical{};
  for (int k = 0; k < 3; ++k) {
    i[k] = inertia[order[k]];
    critical[k] = c * c / (2 * i[k]);  // energy of the axis: decreasing in k
  }
  least_ = critical[2];
  greatest_ = critical[0];
  double total = 0, second = 0;
  const auto add_piece = [&](double low, double high, bool round_last) {
    if (!(high > low)) return;
    piece p{low, high, {0}, {total}};
    for (int panel = 0; panel < panels; ++panel) {
      const auto integrand = [&](double s, int what) {
        const double above = (high - low) * clustered(s), below = (high - low) * clustered(1 - s);
        std::array<double, 3> from{};
        for (int k = 0; k < 3; ++k)
          from[k] =
              2 * i[k] * std::fabs(critical[k] <= low ? above + (low - critical[k]) : below + (critical[k] - high));
        const auto l = orbits(i, from, round_last);
        const double h = low + above;
        const double density = std::exp(-beta * (h - least_)) * l.period * (high - low) * clustered_slope(s);
        return what == 0   ? density
               : what == 1 ? (h - least_) * density
               : what == 2 ? (h - least_) * (h - least_) * density
                           : l.square[what - 3] * density;
      };
      const auto over_panel = [&](int what) {
        return boost::math::quadrature::gauss<double, 10>::integrate(
            [&](double s) { return integrand(s, what); }, panel / double(panels), (panel + 1) / double(panels));
      };
      total += over_panel(0);
      mean_ += over_panel(1);
      second += over_panel(2);
      for (int k = 0; k < 3; ++k) squares_[order[k]] += over_panel(3 + k);
      p.s.push_back((panel + 1) / double(panels));
      p.mass.push_back(total);
    }
    pieces_.push_back(std::move(p));
  };
  add_piece(critical[2], critical[1], true);
  add_piece(critical[1], critical[0], false);
  mean_ /= total;
  variance_ = second / total - mean_ * mean_;
  mean_ += least_;
  for (double& square : squares_) square /= total;
  for (piece& p : pieces_)
    for (double& mass : p.mass) mass /= total;
}

double gibbs_law::energy_cdf(double h) const {
  if (h <= least_) return 0;
  for (const piece& p : pieces_) {
    if (h >= p.high) continue;
    const double s = clustered_inverse((h - p.low) / (p.high - p.low));
    const std::size_t right =
        std::clamp<std::size_t>(gsl_interp_bsearch(p.s.data(), s, 0, p.s.size() - 1) + 1, 1, p.s.size() - 1);
    const double share = (s - p.s[right - 1]) / (p.s[right] - p.s[right - 1]);
    return std::lerp(p.mass[right - 1], p.mass[right], share);
  }
  return 1;
}

}  // namespace polhode
