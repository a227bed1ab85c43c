// SPDX-License-Identifier: Apache-2.0
// Every deviation that the audit states, against its definition in noise_audit.hpp written out over all numbers.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/poisson.hpp>
#include <cmath>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "statistics/noise/noise_audit.hpp"
#include "unit/statistics/audit_numbers.hpp"

namespace polhode::test {
namespace {

constexpr int of_pair[pairs][2] = {{0, 1}, {0, 2}, {1, 2}};

/// What noise_audit.hpp calls two steps in so many, and the sums over them.
class definition {
 public:
  definition(moments law, int window, bool paths) : law_(law), window_(window), paths_(paths) {}

  void add(const numbers& z, const numbers& u) {
    for (std::size_t i = 0; i < z.size(); ++i) {
      all_ += lanes;
      const auto place = static_cast<int>(i) % window_;
      for (int k = 0; k < channels; ++k) add_channel(z, i, k, place);
      if (!u.empty()) add_areas(z, u, i, place);
    }
  }

  std::map<std::string, double> deviations() const {
    std::map<std::string, double> out;
    for (const auto& [what, s] : sums_)
      if (s.numbers >= s.least) out[what] = s.sum / std::sqrt(s.numbers * s.variance);
    for (int k = 0; k < channels; ++k) {
      const auto name = fmt::format(" of channel {}", k + 1);
      // Wilson and Hilferty: the cube root of chi^2/n is normal, of mean 1 - 2/9n and variance 2/9n
      const double part = 2 / (9 * all_);
      out["variance" + name] = (std::pow(squares_[k] / all_, 1.0 / 3) - 1 + part) / std::sqrt(part);
      const boost::math::poisson law(sums_.at("third moment" + name).numbers * std::erfc(4 / std::sqrt(2.0)));
      const bool few = far_[k] < law.mean();
      const double share = few ? cdf(law, far_[k]) : far_[k] > 0 ? cdf(complement(law, far_[k] - 1)) : 1;
      out["tail beyond 4" + name] = (few ? 1 : -1) * quantile(boost::math::normal(), std::min(0.5, share));
    }
    return out;
  }

 private:
  struct summed {
    double sum = 0, numbers = 0, variance = 1, least = 0;
  };
  void add(const std::string& what, double term, double variance, double least) {
    auto& s = sums_[what];
    s = {s.sum + term, s.numbers + 1, variance, least};
  }

  void add_channel(const numbers& z, std::size_t i, int k, int place) {
    const auto name = fmt::format(" of channel {}", k + 1);
    const auto lane_name = [&](const char* what, int nth) {
      return paths_ ? fmt::format("step times a later step{} #{}", name, nth) : what + name;
    };
    const auto at = static_cast<std::size_t>(k);
    for (std::size_t l = 0; l < lanes; ++l) {
      const double x = z[i][at][l];
      add("mean" + name, x, 1, 1);
      squares_[k] += x * x;
      if (place > 1) continue;
      add("third moment" + name, x * x * x - 3 * x, 6, 4096);
      add("fourth moment" + name, x * x * x * x - 6 * x * x + 3, 24, 65536);
      far_[k] += std::fabs(x) > 4;
      for (auto j = at + 1; j < channels; ++j)
        add(fmt::format("channel {} times channel {}", k + 1, j + 1), x * z[i][j][l], 1, 512);
      if (place == 1) add(lane_name("step times next step", 1), x * z[i - 1][at][l], 1, 512);
      if (l + 1 < lanes) add(lane_name("lane times next lane", 2), x * z[i][at][l + 1], 1, 512);
      if (l + 32 < lanes) add(lane_name("lane times lane + 32", 3), x * z[i][at][l + 32], 1, 512);
    }
  }

  void add_areas(const numbers& z, const numbers& u, std::size_t i, int place) {
    for (std::size_t p = 0; p < pairs; ++p) {
      const auto name = fmt::format("area {}{}", of_pair[p][0] + 1, of_pair[p][1] + 1);
      for (std::size_t l = 0; l < lanes; ++l) {
        const double x = u[i][p][l];
        add("mean of " + name, x, law_.square, 512);
        add("variance of " + name, x * x - law_.square, law_.fourth - law_.square * law_.square, 16384);
        if (place > 1) continue;
        for (std::size_t k = 0; k < channels; ++k) {
          const bool own = std::ranges::count(of_pair[p], static_cast<int>(k)) > 0;
          add(fmt::format("{} times channel {}", name, k + 1), x * z[i][k][l], own ? law_.own_channel : law_.square,
              4096);
        }
        for (auto q = p + 1; q < pairs; ++q)  // of three channels any two share one
          add(fmt::format("{} times area {}{}", name, of_pair[q][0] + 1, of_pair[q][1] + 1), x * u[i][q][l],
              law_.shared_channel, 16384);
      }
    }
  }

  moments law_;
  int window_;
  bool paths_;
  std::map<std::string, summed> sums_;
  double all_ = 0, squares_[channels] = {}, far_[channels] = {};
};

/// The same names and numbers but those of whole paths, which path_audit_test.cpp has, and of first steps.
void expect_alike(const std::vector<noise_deviation>& found, const definition& of, const std::string& where,
                  double tolerance = 1e-9) {
  const auto expected = of.deviations();
  std::size_t compared = 0;
  std::map<std::string, int> times;
  for (const auto& d : found) {
    if (d.what.starts_with("first steps") || d.what.starts_with("one block") || d.what.starts_with("number of paths") ||
        d.what == "product of two lanes" || d.what == "product of two steps within 64")
      continue;
    ++compared;
    const bool later = d.what.starts_with("step times a later step");  // three of one name
    const auto name = later ? fmt::format("{} #{}", d.what, ++times[d.what]) : d.what;
    ASSERT_TRUE(expected.contains(name)) << where << ": " << name;
    EXPECT_NEAR(d.z, expected.at(name), tolerance) << where << ": " << name;
  }
  EXPECT_EQ(compared, expected.size()) << where;
}

// Rows at which each sum has just as many numbers as it needs, and 16 less.
TEST(NoiseAudit, StatesWhatItSaysItDoesAndNothingOfTooFewNumbers) {
  const auto z = drawn(8192, 1), u = drawn(8192, 2);
  for (const int cells : {0, 2, 5})
    for (const int rows : {1, 2, 7, 8, 16, 48, 64, 72, 112, 128, 240, 248, 256, 496, 512, 2032, 2048, 8176, 8192}) {
      if (cells != 0 && rows != 512 && rows != 8192) continue;
      const numbers some(z.begin(), z.begin() + rows), areas(u.begin(), u.begin() + rows);
      const auto dw = scaled(some, std::sqrt(dt)), area = scaled(areas, dt / 2);
      noise_audit audit(channels, pairs, cells);
      audit.add({rows, channels, pairs, dw, {}, area, dt});
      definition of(cells == 0 ? moments{} : of_cells(cells), 16, false);
      of.add(some, areas);
      expect_alike(audit.deviations(), of, fmt::format("{} rows, {} cells", rows, cells));
      EXPECT_EQ(audit.increments(), rows * lanes);
    }
}

TEST(NoiseAudit, OfSinglePrecisionIsTheSame) {
  const auto z = drawn(512, 3);
  std::vector<float> singles;
  for (double x : scaled(z, 1)) singles.push_back(static_cast<float>(x));
  noise_audit audit(channels, 0);
  audit.add({512, channels, 0, {}, singles, {}, dt});
  definition of({}, 16, false);
  of.add(z, {});
  expect_alike(audit.deviations(), of, "singles", 1e-6);  // a row of them is added up in single precision
}

// Blocks in pieces, merged: the first steps of a block with those of the blocks 1, 2, 4, 8 before it. So many that
// areas are held against increments.
TEST(NoiseAudit, OfBlocksIsOfAllTheirNumbersAndTheirFirstSteps) {
  constexpr int blocks = 12, rows = 64;
  noise_audit all(channels, pairs);
  definition of({}, 16, false);
  std::vector<numbers> steps;
  for (unsigned b = 0; b < blocks; ++b) {
    steps.push_back(drawn(rows, 10 + b));
    const auto u = drawn(rows, 40 + b);
    noise_audit one(channels, pairs);
    const auto dw = scaled(steps.back(), std::sqrt(dt)), area = scaled(u, dt / 2);
    for (const int half : {0, rows / 2}) {
      const auto from = static_cast<std::size_t>(half * channels * lanes);
      one.add({rows / 2,
               channels,
               pairs,
               std::span(dw).subspan(from, dw.size() / 2),
               {},
               std::span(area).subspan(from, area.size() / 2),
               dt});
    }
    of.add(steps.back(), u);
    all.merge(one);
  }
  const auto found = all.deviations();
  expect_alike(found, of, "blocks");
  double between = 0, terms = 0, next = 0, far = 0;
  for (int b = 0; b < blocks; ++b)
    for (std::size_t k = 0; k < channels; ++k)
      for (int l = 0; l < lanes; ++l) {
        const auto head = [&](int block, int lane) {
          return steps[static_cast<std::size_t>(block)][0][k][static_cast<std::size_t>(lane)];
        };
        for (const int apart : {1, 2, 4, 8})
          if (apart <= b) between += head(b, l) * head(b - apart, l), ++terms;
        if (l + 1 < lanes) next += head(b, l) * head(b, l + 1);
        if (l + 32 < lanes) far += head(b, l) * head(b, l + 32);
      }
  const double rows_of_heads = blocks * channels;
  std::map<std::string, double> z;
  for (const auto& d : found) z[d.what] = d.z;
  EXPECT_NEAR(z.at("one block times another"), between / std::sqrt(terms), 1e-9);
  EXPECT_NEAR(z.at("first steps, lane times next lane"), next / std::sqrt(63 * rows_of_heads), 1e-9);
  EXPECT_NEAR(z.at("first steps, lane times lane + 32"), far / std::sqrt(32 * rows_of_heads), 1e-9);
}

// Its steps 64 in a row, two rows in four.
TEST(NoiseAudit, OfOnePathIsOfItsSteps) {
  constexpr int rows = 520;
  const auto z = drawn(rows, 5), u = drawn(rows, 6);
  std::vector<double> dw, area;
  for (int i = 0; i < rows * lanes + 5; ++i)  // what is left of a row is not heard
    for (std::size_t k = 0; k < channels; ++k) {
      const auto row = static_cast<std::size_t>(i / lanes), lane = static_cast<std::size_t>(i % lanes);
      dw.push_back(std::sqrt(dt) * (row < rows ? z[row][k][lane] : 0));
      area.push_back(dt / 2 * (row < rows ? u[row][k][lane] : 0));
    }
  noise_audit audit(channels, pairs);
  audit.add_path({rows * lanes + 5, channels, pairs, dw, {}, area, dt}, 7);
  definition of({}, 4, true);
  of.add(z, u);
  const auto found = audit.deviations();
  expect_alike(found, of, "one path");
  EXPECT_EQ(found.back().what, "product of two steps within 64");
}

TEST(NoiseAudit, OfNothingKnowsThatNoPathsAreAlikeAndNoMore) {
  const auto found = noise_audit(3, 3).deviations();
  ASSERT_EQ(found.size(), 2u) << found.front().what;
  EXPECT_EQ(found[0].what, "number of paths that start alike");
  EXPECT_EQ(found[1].what, "product of two lanes");
  for (const auto& d : found) EXPECT_EQ(d.z, 0);
}

TEST(NoiseAudit, OfNoChannelSaysNothingOfNumbers) {
  noise_audit audit(0, 0);
  audit.add({4, 0, 0, {}, {}, {}, dt});
  EXPECT_EQ(audit.increments(), 0);
  for (const auto& d : audit.deviations()) EXPECT_TRUE(std::isfinite(d.z)) << d.what;
}

// Two-sided, and shared among them: Bonferroni.
TEST(NoiseAudit, ThresholdIsThatOfAMillionthForAllTogether) {
  const boost::math::normal law;
  for (const std::size_t n : {0, 1, 40})
    EXPECT_NEAR(audit_threshold(n), quantile(complement(law, 1e-6 / 2 / std::max<double>(1, static_cast<double>(n)))),
                1e-9);
}
}  // namespace
}  // namespace polhode::test
