// SPDX-License-Identifier: Apache-2.0
// One exponential of a Gaussian vector against Brownian motion on the group: E exp(C(T dW)) and exp(dt/2 sum C_i^2) as
// matrices of representations, the expectation by tensor Gauss-Hermite quadrature, so nothing is sampled.
//
// One representation alone may miss an error that another sees; the tensor square of the vectors of so(3) holds spins
// 0, 1 and 2. On so(4) = so(3) + so(3) the tensor product of both factors is taken.
#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <span>
#include <vector>

#include <polhode/diagonal_form.hpp>
#include <polhode/lie/so3.hpp>
#include <polhode/lie/so4.hpp>
#include <polhode/lie/son.hpp>
#include <polhode/systems/constant_noise.hpp>
#include <polhode/systems/constant_noise_sized.hpp>

#include "algebra/decompositions.hpp"
#include "unit/integrators/representations.hpp"

namespace polhode {
namespace {

using namespace test;
using Eigen::MatrixXd;

struct noise_case {
  const char* name;
  Eigen::Matrix3d sigma;
  int power;  ///< of dt in the defect: three, and by the symmetry of isotropic noise on so(3) one more
};
void PrintTo(const noise_case& c, std::ostream* out) { *out << c.name; }

Eigen::Matrix3d columns(std::initializer_list<double> by_rows) {
  Eigen::Matrix3d m;
  int i = 0;
  for (const double x : by_rows) m(i / 3, i % 3) = x, ++i;
  return m;
}

const noise_case cases[] = {{"isotropic", columns({0.8, 0, 0, 0, 0.8, 0, 0, 0, 0.8}), 4},
                            {"diagonal", columns({0.3, 0, 0, 0, 0.7, 0, 0, 0, 1.1}), 3},
                            {"two_skew_vectors", columns({0.9, 0.4, 0, 0.1, -0.6, 0, -0.3, 0.5, 0}), 3},
                            {"three_vectors", columns({0.5, -0.2, 0.7, 0.9, 0.3, -0.4, 0.1, 0.8, 0.6}), 3}};

struct WeakOrderTwo : testing::TestWithParam<noise_case> {
  static std::vector<std::vector<MatrixXd>> representations() {
    const auto v = vectors<so3>(0);
    return {v, tensor(v, v)};
  }
};

TEST_P(WeakOrderTwo, DefectFallsFasterThanWithPlainSigma) {
  const Eigen::Matrix3d sigma = GetParam().sigma;
  const constant_noise<so3> noise(sigma);
  for (const auto& r : representations())
    for (const double dt : {0.04, 0.02}) {
      EXPECT_GT(defect(r, sigma, noise.weak_order_two(dt / 2).sigma(), dt / 2), 1e-12)
          << "too near rounding for a slope";
      EXPECT_NEAR(slope(r, sigma, dt, [&](double h) { return MatrixXd(noise.weak_order_two(h).sigma()); }),
                  GetParam().power, 0.1);
      EXPECT_NEAR(slope(r, sigma, dt, [&](double) { return MatrixXd(sigma); }), 2, 0.1);
    }
}

/// R = a (M Q + Q M^T) + b sum_{i<j} [s_i,s_j][s_i,s_j]^T; a = 1/12 and b = 1/4 are right.
Eigen::Matrix3d second_covariance(const Eigen::Matrix3d& sigma, double a, double b) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero(), brackets = m;
  const Eigen::Matrix3d q = sigma * sigma.transpose();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d s = sigma.col(i);
    m += s * s.transpose() - s.squaredNorm() * Eigen::Matrix3d::Identity();
    for (int j = i + 1; j < 3; ++j) {
      const Eigen::Vector3d e = s.cross(Eigen::Vector3d(sigma.col(j)));
      brackets += e * e.transpose();
    }
  }
  return a * (m * q + q * m.transpose()) + b * brackets;
}

MatrixXd root(const Eigen::Matrix3d& covariance) {
  const auto [values, vectors] = symmetric_eigenpairs_of(covariance);
  return vectors * values.cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

TEST_P(WeakOrderTwo, ErrorsInTheSecondCovarianceAreSeen) {
  const Eigen::Matrix3d sigma = GetParam().sigma, q = sigma * sigma.transpose();
  const auto seen = [&](double a, double b) {
    const Eigen::Matrix3d r = second_covariance(sigma, a, b);
    return slope(representations()[1], sigma, 0.02, [&](double dt) { return root(q + dt * r); });
  };
  EXPECT_NEAR(seen(1.0 / 12, 0.25), GetParam().power, 0.05) << "the right one";
  EXPECT_NEAR(seen(1.0 / 12, 0), 2, 0.05) << "without the brackets";
  EXPECT_NEAR(seen(-1.0 / 12, 0.25), 2, 0.05) << "wrong sign of M";
  EXPECT_NEAR(seen(1.0 / 6, 0.25), 2, 0.05) << "1/6 for 1/12";
}

TEST_P(WeakOrderTwo, CovarianceIsTheFormulaAndTheVectorsTendToSigma) {
  const Eigen::Matrix3d sigma = GetParam().sigma, q = sigma * sigma.transpose();
  const constant_noise<so3> noise(sigma);
  for (const double dt : {0.1, 0.01}) {
    const Eigen::Matrix3d t = noise.weak_order_two(dt).sigma();
    EXPECT_LT((t * t.transpose() - q - dt * second_covariance(sigma, 1.0 / 12, 0.25)).norm(), 1e-14);
  }
  EXPECT_LT((noise.weak_order_two(1e-12).sigma() - sigma).norm(), 1e-5);
  EXPECT_TRUE(noise.weak_order_two(1e3).sigma().allFinite());
}

INSTANTIATE_TEST_SUITE_P(Noise, WeakOrderTwo, testing::ValuesIn(cases));

TEST(WeakOrderTwoOnSo3, IsotropicNoiseIsScaled) {
  const constant_noise<so3> noise(Eigen::Matrix3d(0.8 * Eigen::Matrix3d::Identity()));
  const Eigen::Matrix3d expected = 0.8 * std::sqrt(1 - 0.64 * 0.1 / 12) * Eigen::Matrix3d::Identity();
  EXPECT_LT((noise.weak_order_two(0.1).sigma() - expected).norm(), 1e-15);
}

TEST(WeakOrderTwoOnSo3, OneVectorIsExactWithAndWithoutIt) {
  const Eigen::Matrix3d sigma = columns({0.3, 0, 0, 0.4, 0, 0, -0.5, 0, 0});
  const constant_noise<so3> noise(sigma);
  for (const auto& r : WeakOrderTwo::representations())
    for (const double dt : {0.5, 0.1}) {
      EXPECT_LT(defect(r, sigma, sigma, dt, 16), 1e-13);
      EXPECT_LT(defect(r, sigma, noise.weak_order_two(dt).sigma(), dt, 16), 1e-13);
    }
}

TEST(NoiseClass, SeveralVectorsAlongOneLineAreOneToRounding) {
  const Eigen::Vector3d line(0.3, -0.7, 1.1);
  const auto class_with = [&](double off) {
    Eigen::Matrix3d sigma;
    sigma << line, line / 3, -7 * line;
    sigma(0, 1) += off;
    return class_of(sigma);
  };
  EXPECT_EQ(class_with(0), noise_class::one_vector);
  EXPECT_EQ(class_with(1e-13), noise_class::general);
}

TEST(NoiseClass, NoVectorsOrOrthogonalOnesOfOneLengthWhateverThat) {
  EXPECT_EQ(class_of(Eigen::Matrix3d(Eigen::Matrix3d::Zero())), noise_class::none);
  for (const double length : {1e-3, 1.0, 1e3})
    EXPECT_EQ(class_of(Eigen::Matrix3d(length * Eigen::Matrix3d::Identity())), noise_class::isotropic) << length;
}

// Whichever is the longest: a vector of the size of its rounding has no direction of its own.
TEST(NoiseClass, OneLongVectorBesideRoundingIsOne) {
  for (int longest = 0; longest < 3; ++longest) {
    Eigen::Matrix3d sigma = 1e-18 * columns({3, -2, 1, -1, 4, 2, 2, 1, -5});
    sigma.col(longest) = Eigen::Vector3d(0.3, -0.7, 1.1);
    EXPECT_EQ(class_of(sigma), noise_class::one_vector) << longest;
  }
}

TEST(NoiseClass, IsThatOfAnyMultiple) {
  const Eigen::Matrix3d turn = polar_rotation_of(columns({0.5, -0.2, 0.7, 0.9, 0.3, -0.4, 0.1, 0.8, 0.6}));
  const Eigen::Matrix3d unequal = turn * Eigen::Vector3d(1, 1.1, 0.9).asDiagonal();
  for (const double scale : {1e-8, 1e-3, 1e3, 1e8}) {
    EXPECT_EQ(class_of(Eigen::Matrix3d(scale * turn)), noise_class::isotropic) << scale;
    EXPECT_EQ(class_of(Eigen::Matrix3d(scale * unequal)), noise_class::general) << scale;
  }
}

// Eigen's solver as the other method: a full matrix, one that is indefinite, equal values, a graded one, a diagonal.
TEST(DiagonalForm, IsThatOfEigensSolver) {
  const auto symmetric = [](const MatrixXd& a) -> MatrixXd { return a + a.transpose(); };
  MatrixXd full(9, 9);
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j) full(i, j) = std::sin(1.0 + 3 * i + 5 * j + i * j);
  const MatrixXd graded = Eigen::Vector4d(1, 1e-3, 1e-6, 1e-9).asDiagonal(), ones = MatrixXd::Ones(5, 5);
  for (const MatrixXd& a :
       {symmetric(full), MatrixXd(full * full.transpose()), ones, MatrixXd(-ones), MatrixXd(MatrixXd::Zero(3, 3)),
        MatrixXd(graded * symmetric(full).topLeftCorner(4, 4) * graded),
        MatrixXd(Eigen::Vector3d(3, -1, 2).asDiagonal())}) {
    const auto [values, axes] = diagonal_form_of(a);
    const double size = a.norm();
    EXPECT_LE((values - symmetric_eigenpairs_of(a).values).norm(), 1e-14 * size);
    EXPECT_LE((axes * values.asDiagonal() * axes.transpose() - a).norm(), 1e-14 * size);
    EXPECT_LE((axes.transpose() * axes - MatrixXd::Identity(a.rows(), a.rows())).norm(), 1e-14 * std::sqrt(a.rows()));
  }
}

// Products of two entries would overflow, or vanish.
TEST(DiagonalForm, IsThatOfAnyMultiple) {
  const Eigen::Matrix3d a{{1, 0.3, -0.2}, {0.3, -0.5, 0.1}, {-0.2, 0.1, 0.2}};
  const auto known = symmetric_eigenpairs_of(a).values;
  for (const double scale : {1e-200, 1e200}) {
    const auto [values, axes] = diagonal_form_of(Eigen::Matrix3d(scale * a));
    EXPECT_LE((values / scale - known).norm(), 1e-14) << scale;
    EXPECT_LE((axes * (values / scale).asDiagonal() * axes.transpose() - a).norm(), 1e-14) << scale;
  }
}

// det a = 1e-18 and the greater value is 1 + 1e-18: the lesser is 1e-18 (1 - 1e-18).
TEST(DiagonalForm, OfAGradedMatrixHasEveryValueToItsOwnSize) {
  const Eigen::Matrix2d a{{1, 1e-9}, {1e-9, 2e-18}};
  EXPECT_NEAR(diagonal_form_of(a).values[0], 1e-18, 1e-32);
}

// One vector, of which what is across vanishes exactly; and one that leaves 1e-6 of the axis that stands in for it.
TEST(PolarRotation, OfOneVectorIsOrthogonalToRounding) {
  for (const double scale : {1e-9, 1.0})
    for (const Eigen::RowVector3d& along : {Eigen::RowVector3d(0.6, 0.8, 0), Eigen::RowVector3d(1, 1e-6, 0)}) {
      Eigen::Matrix3d sigma = Eigen::Matrix3d::Zero();
      sigma.row(2) = scale * along;
      const Eigen::Matrix3d turn = polar_rotation_of(sigma);
      EXPECT_LT((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14) << scale << ' ' << along;
      EXPECT_LT((square_root_of(Eigen::Matrix3d(sigma * sigma.transpose())) * turn - sigma).norm(), 1e-14 * scale);
    }
}

TEST(PolarRotation, OfAnyScaleAndOfNothing) {
  const Eigen::Matrix3d sigma = columns({0.5, 0, 0, 0, 0, -0.4, 0, 0, 0});
  const Eigen::Matrix3d turn = polar_rotation_of(sigma);
  for (const double scale : {1e-100, 1e100})
    EXPECT_LT((polar_rotation_of(Eigen::Matrix3d(scale * sigma)) - turn).norm(), 1e-15) << scale;
  const Eigen::Matrix3d none = polar_rotation_of(Eigen::Matrix3d(Eigen::Matrix3d::Zero()));
  EXPECT_LT((none * none.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-15);
}

TEST(PolarRotation, IsOrthogonalAndGivesSigmaBackWhateverItsRank) {
  for (const double third : {1.0, 1e-6, 1e-9, 1e-15, 0.0})
    for (const double second : {1.0, 1e-7, 0.0}) {
      Eigen::Matrix3d sigma = columns({0.5, -0.2, 0.7, 0.9, 0.3, -0.4, 0.1, 0.8, 0.6});
      sigma.col(1) = sigma.col(0) + second * sigma.col(1);
      sigma.col(2) = sigma.col(0) - third * sigma.col(2);
      const Eigen::Matrix3d turn = polar_rotation_of(sigma);
      EXPECT_LT((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-8) << second << ' ' << third;
      const Eigen::Matrix3d root = square_root_of(Eigen::Matrix3d(sigma * sigma.transpose()));
      EXPECT_LT((root * turn - sigma).norm(), 5e-8) << second << ' ' << third;
    }
}

// Any algebra: six vectors that mix both factors of so(4). Four nodes are exact to degree seven: to dt^3.
TEST(WeakOrderTwoOnSo4, DefectFallsLikeTheThirdPower) {
  Eigen::Matrix<double, 6, 6> sigma;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j) sigma(i, j) = 0.5 * std::sin(1.0 + 3 * i + 5 * j + i * j);
  const constant_noise<so4> noise(sigma);
  const auto r = tensor(vectors<so4>(0), vectors<so4>(3));
  EXPECT_NEAR(slope(
                  r, sigma, 0.02, [&](double h) { return MatrixXd(noise.weak_order_two(h).sigma()); }, 4),
              3, 0.1);
  EXPECT_NEAR(slope(
                  r, sigma, 0.02, [&](double) { return MatrixXd(sigma); }, 4),
              2, 0.1);
}

// As many as dimensions as they are, however short, without those that vanish; more by their covariance.
TEST(ConstantNoise, OfAnyListHasItsCovariance) {
  using noise = constant_noise<so3>;
  using column = noise::column;
  const std::vector<column> few{{{1e-5, 2e-5, 0}}, {{0, 0, 0}}, {{0.3, 0, 1e-9}}};
  const auto some = noise::from_vectors(few).sigma();
  EXPECT_EQ(some, columns({1e-5, 0.3, 0, 2e-5, 0, 0, 0, 1e-9, 0}));
  const std::vector<column> many{{{0.3, 0, 0}}, {{0.1, 0.4, 0}}, {{0, -0.2, 0.5}}, {{0.2, 0.2, 0.2}}};
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& v : many)
    covariance += Eigen::Vector3d(v[0], v[1], v[2]) * Eigen::Vector3d(v[0], v[1], v[2]).transpose();
  const Eigen::Matrix3d root = noise::from_vectors(many).sigma();
  EXPECT_LT((root * root.transpose() - covariance).norm(), 1e-15);
  EXPECT_LT((root - root.transpose()).norm(), 1e-15);
}

// One vector in the first place is one channel; along one line from several places, all are drawn.
TEST(ConstantNoise, DrawsNoneOneOrAllOfItsChannels) {
  const auto active = [](std::initializer_list<double> by_rows) {
    return constant_noise<so3>(columns(by_rows)).active_channels();
  };
  EXPECT_EQ(active({0, 0, 0, 0, 0, 0, 0, 0, 0}), 0);
  EXPECT_EQ(active({1e-5, 0, 0, 0, 0, 0, 2e-5, 0, 0}), 1);
  EXPECT_EQ(active({1, 1e-4, 0, 0, 0, 0, 2, 2e-4, 0}), 3);
  EXPECT_EQ(active({1, 0, 1e-4, 0, 0, 0, 2, 0, 2e-4}), 3);
  EXPECT_EQ(active({0, 1, 0, 0, 0, 0, 0, 2, 0}), 3);
  EXPECT_EQ(active({1, 0, 0, 0, 1, 0, 0, 0, 0}), 3);
}

TEST(ConstantNoise, OfOpenSizeDrawsNoneOneOrAllOfItsChannels) {
  const auto active = [](std::initializer_list<int> places, double length) {
    Eigen::MatrixXd sigma = Eigen::MatrixXd::Zero(6, 6);
    for (const int place : places) sigma.col(place) = length * Eigen::VectorXd::LinSpaced(6, -0.3, 0.8);
    return constant_noise<son>(sigma).active_channels();
  };
  EXPECT_EQ(active({}, 1), 0);
  EXPECT_EQ(active({0}, 1e-4), 1);
  EXPECT_EQ(active({1}, 1), 6);
  EXPECT_EQ(active({5}, 1), 6);
  EXPECT_EQ(active({0, 3}, 1e-4), 6);
  EXPECT_EQ(constant_noise<son>::isotropic(0.3, 6).active_channels(), 6);
}

// As many vectors as components as they are; what they do is their sum, and that of their brackets.
TEST(ConstantNoise, OfOpenSizeAddsUpItsVectors) {
  using noise = constant_noise<son>;
  std::vector<std::vector<double>> list;
  for (int i = 0; i < 6; ++i)
    for (auto& v = list.emplace_back(); v.size() < 6;)
      v.push_back(i == 5 && v.size() == 3 ? 1 : std::sin(static_cast<double>(6 * i) + static_cast<double>(v.size())));
  for (const std::size_t count : {std::size_t{2}, std::size_t{6}}) {
    const auto some = noise::from_vectors(std::span(list).first(count), 6);
    noise::column dw(6), expected(6), of_areas(6);
    vec<double, pairs_of<noise::channels>> area(15);
    int pair = 0;
    for (int i = 0; i < 6; ++i) {
      dw[i] = 0.1 * (i + 1);
      noise::column v(6);
      for (int k = 0; k < 6; ++k) {
        v[k] = i < static_cast<int>(count) ? list[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)] : 0;
        EXPECT_EQ(some.sigma()(k, i), v[k]);
      }
      expected = expected + dw[i] * v;
      for (int j = i + 1; j < 6; ++j, ++pair) {
        area[pair] = 0.01 * (pair + 1);
        if (j >= static_cast<int>(count)) continue;
        noise::column w(6);
        for (int k = 0; k < 6; ++k) w[k] = list[static_cast<std::size_t>(j)][static_cast<std::size_t>(k)];
        of_areas = of_areas + area[pair] * son::bracket(v, w);
      }
    }
    const auto sum = some.noise(dw), areas = some.area_noise(area);
    for (int k = 0; k < 6; ++k) {
      EXPECT_NEAR(sum[k], expected[k], 1e-15);
      EXPECT_NEAR(areas[k], of_areas[k], 1e-15);
    }
  }
}

// Areas that were not asked for are none, whatever stood in their place.
TEST(ConstantNoise, OfOpenSizeIsNothingWithoutWeights) {
  const auto noise = constant_noise<son>::isotropic(0.7, 6);
  vec<double, pairs_of<constant_noise<son>::channels>> area(15);
  for (int pair = 0; pair < 15; ++pair) area[pair] = 1;
  area = {};
  const auto sum = noise.area_noise(area);
  ASSERT_EQ(sum.size, 6);
  for (int k = 0; k < 6; ++k) EXPECT_EQ(sum[k], 0);
}

}  // namespace
}  // namespace polhode
