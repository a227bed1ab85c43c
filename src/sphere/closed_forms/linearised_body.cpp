#include "sphere/closed_forms/linearised_body.hpp"

#include "algebra/decompositions.hpp"

namespace polhode {

linearised_body linearised_about(int axis, const std::array<double, 3>& inertia, double theta, double momentum,
                                 double sigma) {
  const auto j = static_cast<std::size_t>(axis), k = (j + 1) % 3, l = (j + 2) % 3;
  const double c = momentum, a = 1 / inertia[k] - 1 / inertia[j], b = 1 / inertia[l] - 1 / inertia[j];
  return {{{{-theta * c * c * a, -c * b}, {c * a, -theta * c * c * b}}}, sigma};
}

double mean_square_growth(const linearised_body& body) {
  const auto& a = body.drift;
  const double sum = a[0][0] + a[1][1], stretch = a[0][0] - a[1][1], shear = a[0][1] + a[1][0],
               turn = a[0][1] - a[1][0], lost = 2 * body.noise * body.noise;
  // The turns of the noise by an angle turn what is not isotropic by twice that, and average it away.
  Eigen::Matrix3d moments;
  moments << sum, stretch, shear, stretch, sum - lost, turn, shear, -turn, sum - lost;
  return eigenvalues_of(moments).real().maxCoeff();
}

}  // namespace polhode
