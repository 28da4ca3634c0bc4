// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace ridgeline::simulate {
namespace {

constexpr int kDraws = 200000;

TEST(Random, EqualKeysGiveEqualNumbersAndOtherKeysOthers) {
  Random a({7, 1});
  Random b({7, 1});
  Random other({7, 2});
  Random swapped({1, 7});
  for (int i = 0; i < 100; ++i) {
    const std::uint64_t expected = a.next();
    EXPECT_EQ(b.next(), expected);
    EXPECT_NE(other.next(), expected);
    EXPECT_NE(swapped.next(), expected);
  }
}

TEST(Random, WithoutAKeyIsThePublishedSplitMix64OfStateZero) {
  Random random({});
  EXPECT_EQ(random.next(), 0xe220a8397b1dcdafULL);
  EXPECT_EQ(random.next(), 0x6e789e6aa1b965f4ULL);
}

TEST(Random, UniformHasItsMeanAndVariance) {
  Random random({3});
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.uniform(2.0, 4.0);
    ASSERT_GE(x, 2.0);
    ASSERT_LT(x, 4.0);
    sum += x;
    squares += (x - 3.0) * (x - 3.0);
  }
  EXPECT_NEAR(sum / kDraws, 3.0, 5.0 / std::sqrt(3.0 * kDraws));  // 5 standard errors
  EXPECT_NEAR(squares / kDraws, 1.0 / 3.0, 0.005);
}

TEST(Random, NormalHasItsMomentsAndTails) {
  Random random({4});
  double sum = 0.0;
  double squares = 0.0;
  int beyond = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double x = random.normal();
    sum += x;
    squares += x * x;
    beyond += std::abs(x) > 1.959964 ? 1 : 0;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 5.0 / std::sqrt(kDraws));
  EXPECT_NEAR(squares / kDraws, 1.0, 5.0 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(static_cast<double>(beyond) / kDraws, 0.05, 0.0025);
}

TEST(Random, IntegerReachesBothEndsEqually) {
  Random random({5});
  std::map<int, int> counts;
  for (int i = 0; i < 40000; ++i) ++counts[random.integer(-1, 2)];
  ASSERT_EQ(counts.size(), 4U);
  EXPECT_EQ(counts.begin()->first, -1);
  EXPECT_EQ(counts.rbegin()->first, 2);
  for (const auto& [value, count] : counts) {
    EXPECT_NEAR(count, 10000, 450) << value;  // 5 standard deviations
  }
}

TEST(Random, ChanceOfZeroNeverAndOfOneAlways) {
  Random random({6});
  for (int i = 0; i < 1000; ++i) {
    EXPECT_FALSE(random.chance(0.0));
    EXPECT_TRUE(random.chance(1.0));
  }
}

}  // namespace
}  // namespace ridgeline::simulate
