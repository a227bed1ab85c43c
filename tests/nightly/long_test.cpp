// Runs too long for every push: ctest -L nightly.
#include <gtest/gtest.h>

#include <cmath>

#include <gsl/gsl_cdf.h>

#include <polhode/noise/normal.hpp>

#include "ensemble/paths.hpp"
#include "registry/scene.hpp"
#include "registry/verify.hpp"
#include "statistics/sample.hpp"

namespace polhode {
namespace {

constexpr std::uint64_t pieces = 2000, per_piece = 100'000;

// 2e8 normals: moments 1 to 8 and the law, against what chance allows.
TEST(Normals, LongRunOfMomentsAndLaw) {
  struct sums {
    double power[8] = {};
    std::uint64_t tail[4] = {};  // |x| > 2, 3, 4, 5
  };
  std::vector<sums> parts(pieces);
  parallel_for(2, static_cast<int>(pieces), [&](int piece) {
    auto& p = parts[static_cast<std::size_t>(piece)];
    for (std::uint64_t i = 0; i < per_piece / 2; ++i) {
      const auto pair = normal_pair({1, noise_kind::increment, static_cast<std::uint64_t>(piece), i}, 0);
      for (const double x : pair.c) {
        double power = 1;
        for (double& sum : p.power) sum += power *= x;
        for (int k = 0; k < 4; ++k) p.tail[k] += std::fabs(x) > k + 2;
      }
    }
  });
  const double n = static_cast<double>(pieces * per_piece);
  const double exact[] = {0, 1, 0, 3, 0, 15, 0, 105}, variance[] = {1, 2, 15, 96, 945, 10170, 135135, 2016000};
  for (int k = 0; k < 8; ++k) {
    double sum = 0;
    for (const auto& p : parts) sum += p.power[k];
    EXPECT_NEAR(sum / n, exact[k], 4 * std::sqrt(variance[k] / n)) << "moment " << k + 1;
  }
  for (int k = 0; k < 4; ++k) {
    double count = 0;
    for (const auto& p : parts) count += static_cast<double>(p.tail[k]);
    const double expected = n * 2 * gsl_cdf_ugaussian_Q(k + 2);
    EXPECT_NEAR(count, expected, 4 * std::sqrt(expected)) << "beyond " << k + 2;
  }
}

// Ten million steps: rounding grows like a random walk, and its growth law is found.
TEST(Casimir, TenMillionSteps) {
  verify_options options;
  options.experiments = {"casimir"};
  options.effort = effort::thorough;
  options.threads = 2;
  const auto r = verify(load_scene("paper"), options);
  for (const auto& v : r.verdicts) EXPECT_EQ(v.kind, report::verdict_kind::holds) << v.scheme << ": " << v.reason;
  for (const auto& f : r.fits)
    if (f.quantity == "drift_over_steps") {
      EXPECT_LT(f.order, 0.8) << f.scheme;
    }
}

}  // namespace
}  // namespace polhode
