// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/halved_step.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

namespace ridgeline::reconstruct {
namespace {

/// A step from 1 towards the minimum at 0 that is `length` times as long as it should be.
std::optional<double> stepped(double length, double largest_share = 1.0) {
  return halved_step(
      1.0, [&](double share) { return 1.0 - share * length; }, [](double x) { return x * x; },
      largest_share);
}

TEST(HalvedStep, IsHalvedUntilTheSumDoesNotGrow) {
  EXPECT_EQ(stepped(1.0), 0.0);
  EXPECT_EQ(stepped(2.0), -1.0);
  EXPECT_EQ(stepped(5.0), -0.25);
  EXPECT_FALSE(stepped(1e6).has_value());
}

TEST(HalvedStep, BeginsWithTheLargestShare) {
  EXPECT_EQ(stepped(1.0, 0.5), 0.5);
  EXPECT_EQ(stepped(5.0, 0.5), -0.25);
}

/// Steps that are too long go to and fro about the minimum of one part of a sum, ever farther, if
/// that part is too small to show in the sum.
TEST(HalvedStep, OfHalfALengthEndsAnOscillation) {
  constexpr double kOvershoot = 2.3;
  const auto sum_of = [](double x) { return 1e6 + x * x; };
  const auto after = [&](double x, double largest_share) {
    return *halved_step(
        sum_of(x), [&](double share) { return x - share * kOvershoot * x; }, sum_of, largest_share);
  };
  EXPECT_GT(std::abs(after(1e-3, 1.0)), 1e-3);
  EXPECT_LT(std::abs(after(1e-3, 0.5)), 0.2e-3);
}

}  // namespace
}  // namespace ridgeline::reconstruct
