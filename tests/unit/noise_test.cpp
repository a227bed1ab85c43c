#include <gtest/gtest.h>

#include <cmath>

#include <polhode/increment.hpp>
#include <polhode/noise/normal.hpp>

#include <gsl/gsl_cdf.h>

#include "statistics/sample.hpp"

namespace polhode {
namespace {

// Known answers of the Random123 distribution (kat_vectors, philox4x32-10).
TEST(Philox, KnownAnswers) {
  using words = philox_words<std::uint64_t>;
  EXPECT_EQ(philox4x32_10<std::uint64_t>({0, 0, 0, 0}, 0), (words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox4x32_10<std::uint64_t>({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, 0xffffffffffffffff),
            (words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox4x32_10<std::uint64_t>({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, 0x299f31d0a4093822),
            (words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Philox, PacksGiveTheSameBits) {
  using B = bits_of<pack>;
  const B path([](auto lane) { return 0x123456789ABull + lane; });
  const noise_address a{0xDEADBEEF12345678, noise_kind::area, 0, 0xABCDEF012345};
  const auto packed = random_words(a, path, 3);
  const auto normal = normal_pair<pack>(a, path, 3);
  for (std::size_t lane = 0; lane < pack::size(); ++lane) {
    const noise_address one{a.seed, a.kind, 0x123456789ABull + lane, a.step};
    for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(packed[k][lane], random_words(one, 3)[k]);
    for (int k = 0; k < 2; ++k) EXPECT_EQ(normal[k][lane], normal_pair(one, 3)[k]);
  }
}

TEST(Logarithm, IsGoodToTheLastPlace) {
  for (int i = 1; i < 20000; ++i)
    for (const double x : {i * 5e-5, i * 1e-16, 1 - i * 1e-9, i * 1e12}) {
      EXPECT_NEAR(logarithm(x), std::log(x), 2.3e-16 * std::max(std::fabs(std::log(x)), 1e-9)) << x;
      EXPECT_EQ(logarithm(pack(x))[0], logarithm(x));
    }
}

TEST(Address, EveryFieldMatters) {
  const noise_address a{1, noise_kind::increment, 5, 9};
  const auto bits = random_words(a, 0);
  EXPECT_NE(bits, random_words(a, 1));
  EXPECT_NE(bits, random_words({2, a.kind, a.path, a.step}, 0));
  EXPECT_NE(bits, random_words({1ull << 40 | 1, a.kind, a.path, a.step}, 0));
  EXPECT_NE(bits, random_words({a.seed, noise_kind::area, a.path, a.step}, 0));
  EXPECT_NE(bits, random_words({a.seed, a.kind, a.path + (1ull << 40), a.step}, 0));
  EXPECT_NE(bits, random_words({a.seed, a.kind, a.path, a.step + (1ull << 40)}, 0));
}

TEST(Uniform, IsNeverZeroOrOne) {
  EXPECT_GT(uniform_of<double>(std::uint64_t{0}, std::uint64_t{0}), 0.0);
  EXPECT_LT(uniform_of<double>(std::uint64_t{0xffffffff}, std::uint64_t{0xffffffff}), 1.0);
}

TEST(Normal, AskingForFewerChangesNothing) {
  const noise_address a{3, noise_kind::increment, 1, 2};
  const auto all = normals<6>(a);
  for (int wanted = 0; wanted <= 6; ++wanted) {
    const auto some = normals<6>(a, wanted);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(some[i], i < wanted ? all[i] : 0.0);
  }
}

class NormalSample : public testing::Test {
 protected:
  static constexpr int n = 200'000;
  static std::vector<double> draw() {
    std::vector<double> x;
    for (std::uint64_t path = 0; x.size() < n; ++path) {
      const auto v = normals<3>({17, noise_kind::increment, path % 400, path / 400});
      x.insert(x.end(), v.c.begin(), v.c.end());
    }
    return x;
  }
};

TEST_F(NormalSample, HasTheNormalLaw) {
  const auto ks = ks_distance(draw(), gsl_cdf_ugaussian_P);
  EXPECT_LT(ks.value, 1.63 / std::sqrt(double(n)));  // 1 % point of Kolmogorov's law; the seed is fixed
}

TEST_F(NormalSample, HasTheNormalMoments) {
  const auto x = draw();
  const double exact[] = {0, 1, 0, 3, 0, 15, 0, 105}, variance[] = {1, 2, 15, 96, 945, 10170, 135135, 2016000};
  for (int k = 1; k <= 8; ++k) {
    double mean = 0;
    for (const double v : x) mean += std::pow(v, k) / static_cast<double>(x.size());
    EXPECT_NEAR(mean, exact[k - 1], 4 * std::sqrt(variance[k - 1] / n)) << "moment " << k;
  }
}

TEST_F(NormalSample, ChannelsPathsAndStepsAreUncorrelated) {
  double channels = 0, paths = 0, steps = 0;
  for (std::uint64_t path = 0; path < 300; ++path)
    for (std::uint64_t step = 0; step < 300; ++step) {
      const auto at = [&](std::uint64_t p, std::uint64_t s) { return normals<2>({5, noise_kind::increment, p, s}); };
      const auto here = at(path, step);
      channels += here[0] * here[1];
      paths += here[0] * at(path + 1, step)[0];
      steps += here[0] * at(path, step + 1)[0];
    }
  for (const double sum : {channels, paths, steps}) EXPECT_LT(std::fabs(sum) / 300, 4.0);
}

// Chen's relation against the areas of a piecewise linear path computed from their definition.
TEST(Chen, GivesTheAreaOfThePath) {
  std::vector<vec<double, 3>> dw;
  for (std::uint64_t i = 0; i < 17; ++i) dw.push_back(normals<3>({2, noise_kind::increment, 0, i}));
  wiener_levy<double, 3> sum{{1.0, dw[0]}, {}};
  for (std::size_t i = 1; i < dw.size(); ++i) sum = chen(sum, {{1.0, dw[i]}, {}});
  int pair = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = i + 1; j < 3; ++j, ++pair) {
      double wi = 0, wj = 0, area = 0;
      for (const auto& d : dw) {
        area += 0.5 * ((wi + 0.5 * d[i]) * d[j] - (wj + 0.5 * d[j]) * d[i]);
        wi += d[i];
        wj += d[j];
      }
      EXPECT_NEAR(sum.area[pair], area, 1e-12);
      EXPECT_NEAR(sum.dw[i], wi, 1e-12);
    }
  EXPECT_EQ(sum.dt, 17.0);
}

TEST(Chen, IsAssociative) {
  const auto some = [](std::uint64_t i) {
    return wiener_levy<double, 3>{{1.0, normals<3>({2, noise_kind::increment, 1, i})},
                                  normals<3>({2, noise_kind::area, 1, i})};
  };
  const auto left = chen(chen(some(0), some(1)), some(2)), right = chen(some(0), chen(some(1), some(2)));
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(left.area[k], right.area[k], 1e-14);
}

}  // namespace
}  // namespace polhode
