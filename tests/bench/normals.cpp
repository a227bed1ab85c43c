// SPDX-License-Identifier: Apache-2.0
// Normals one at a time, each library's own way.
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/normal_distribution.hpp>
#include <memory>
#include <random>

#include "bench/yardsticks.hpp"

namespace polhode::bench {
namespace {

template <class Draw>
double sum_of(int count, Draw draw) {
  double sum = 0;
  for (int i = 0; i < count; ++i) sum += draw();
  return sum;
}

}  // namespace

double sum_of_std_normals(int count) {
  static std::mt19937_64 generator(1);
  static std::normal_distribution<double> normal;
  return sum_of(count, [&] { return normal(generator); });
}

double sum_of_boost_normals(int count) {
  static boost::random::mt19937_64 generator(1);
  boost::random::normal_distribution<double> normal;
  return sum_of(count, [&] { return normal(generator); });
}

double sum_of_gsl_normals(int count) {
  static const std::unique_ptr<gsl_rng, decltype(&gsl_rng_free)> generator(gsl_rng_alloc(gsl_rng_mt19937),
                                                                           gsl_rng_free);
  return sum_of(count, [&] { return gsl_ran_gaussian_ziggurat(generator.get(), 1.0); });
}

}  // namespace polhode::bench
