// SPDX-License-Identifier: Apache-2.0
// A chain of spins at temperature kT samples its Gibbs law: <S_i.S_i+1> = -(coth(J/kT) - kT/J) on an open chain (Fisher
// 1964), held with the test kit: a verdict whose false alarms are as rare as it says.
#include <cmath>
#include <cstdio>
#include <polhode/integrate.hpp>
#include <polhode/schemes/strang_two_turns.hpp>
#include <polhode/systems/spins.hpp>
#include <polhode/testing/bounded_mean_test.hpp>

int main() {
  using namespace polhode;
  using chain = spins;
  constexpr int n = 4;
  const double coupling = 1, kT = 0.5, theta = 0.5;
  Eigen::MatrixXd exchange = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i + 1 < n; ++i) exchange(i, i + 1) = exchange(i + 1, i) = coupling;
  const chain coupled(Eigen::Matrix3d::Zero(), {}, exchange, theta,
                      constant_noise<chain::group>::isotropic(std::sqrt(2 * theta * kT), 3 * n));
  auto state = zeros<vec<double, chain::dimension>>(3 * n);
  for (int i = 0; i < n; ++i) state[3 * i + 2] = 1;

  const double exact = -(1 / std::tanh(coupling / kT) - kT / coupling);
  testkit::bounded_mean_test mean(exact, 0.05, 1e-6, {-1, 1});
  noise_address address{.seed = 1};
  for (; mean.wants_more(); ++address.path) {
    const auto end = integrate<strang_two_turns>(coupled, state, 0.05, 200, address);
    mean.add(coupled.energy(end) / (coupling * (n - 1)));
  }
  std::printf("<S_i.S_i+1>: exact %.4f; %s\n", exact, mean.reason().c_str());
  return mean.holds() ? 0 : 1;
}
