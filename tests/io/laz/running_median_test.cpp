// SPDX-License-Identifier: BSD-3-Clause
#include "io/cloud/laz/running_median.h"

#include <gtest/gtest.h>

#include <random>

namespace ridgeline::io::laz {
namespace {

TEST(RunningMedian, StartsAtZero) { EXPECT_EQ(RunningMedian().get(), 0); }

TEST(RunningMedian, FollowsHandCheckedSteps) {
  struct Step {
    std::int32_t value, median;
  };
  RunningMedian median;
  for (const auto& [value, expected] : {
           Step{5, 0},     // 0 0 0 0 5, from now on the smallest is dropped
           Step{5, 0},     // 0 0 0 5 5
           Step{5, 5},     // 0 0 5 5 5
           Step{-3, 5},    // -3 0 5 5 5, from now on the largest
           Step{7, 5},     // -3 0 5 5 7, the smallest
           Step{9, 5},     // 0 5 5 7 9
           Step{-8, 5},    // -8 5 5 7 9, the largest
           Step{-9, 5},    // -9 -8 5 5 7
           Step{-10, -8},  // -10 -9 -8 5 5
       }) {
    median.add(value);
    EXPECT_EQ(median.get(), expected) << value;
  }
}

TEST(RunningMedian, ReachesAConstantAfterFiveValues) {
  std::mt19937 rng(3);
  for (int trial = 0; trial < 1000; ++trial) {
    RunningMedian median;
    for (int i = 0; i < 20; ++i) median.add(static_cast<std::int32_t>(rng()));
    for (int i = 0; i < 5; ++i) median.add(trial);
    EXPECT_EQ(median.get(), trial);
  }
}

}  // namespace
}  // namespace ridgeline::io::laz
