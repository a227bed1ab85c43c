// SPDX-License-Identifier: Apache-2.0
// Processor time is charged to what a thread says it works on.
#include "platform/cpu_profile.hpp"

#include <gtest/gtest.h>

#include <ctime>

#include "ensemble/noise/paths.hpp"

namespace polhode {
namespace {

double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void work_for(double seconds) {
  const double end = thread_seconds() + seconds;
  while (thread_seconds() < end) continue;
}

TEST(CpuProfile, ChargesEachThreadToWhatItWorksOn) {
  working_on("");
  cpu_profile profile;
  parallel_for(2, 4, [](int i) {
    working_on(i % 2 == 0 ? "even" : "odd");
    work_for(i % 2 == 0 ? 0.06 : 0.02);
  });
  const auto found = profile.take();
  EXPECT_NEAR(found.at("even"), 0.12, 0.015);
  EXPECT_NEAR(found.at("odd"), 0.04, 0.015);
}

TEST(CpuProfile, CountsFromTheLastLook) {
  cpu_profile profile;
  working_on("before");
  work_for(0.02);
  profile.take();
  working_on("after");
  work_for(0.02);
  const auto found = profile.take();
  EXPECT_NEAR(found.at("after"), 0.02, 0.01);
  EXPECT_FALSE(found.contains("before") && found.at("before") > 0.005);
}

TEST(CpuProfile, TakesNothingAfterItsEnd) {
  { const cpu_profile over; }
  working_on("unseen");
  work_for(0.01);
  cpu_profile profile;
  EXPECT_FALSE(profile.take().contains("unseen") && profile.take().at("unseen") > 0.005);
}

}  // namespace
}  // namespace polhode
