// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/beyond/depth_consensus/strip_correlation.h"

#include "tests/support/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

namespace ridgeline::reconstruct {
namespace {

constexpr int kLeft = 60;             // samples of the left strip
constexpr int kRight = 300;           // of the right one, half as far apart
constexpr double kPlace = 80;         // of the first left sample
constexpr double kCorrelated = 0.99;  // bilinear interpolation smooths
constexpr double kChance = 0.6;       // 60 x 5 samples smoothed over 4

/// Smooth random rows that both strips show, the left one at kPlace of the right one; each row of the
/// right one `shear` samples further per row.
FlankStrips make_strips(double shear = 0.0, bool swapped = false) {
  test::Random random(5);
  FlankStrips strips;
  strips.left.n_along = kLeft;
  strips.right.n_along = kRight;
  strips.left.n_bands = strips.right.n_bands = 1;
  for (const std::size_t side : {0U, 1U}) {
    std::vector<double> wave(std::size_t{2} * kRight);
    for (double& value : wave) value = random.normal(0.1);
    for (std::size_t i = 4; i < wave.size(); ++i) wave[i] = 0.7 * wave[i - 1] + wave[i];
    const auto at = [&](double x) {
      const auto i = static_cast<std::size_t>(x);
      const double share = x - std::floor(x);
      return (1.0 - share) * wave[i] + share * wave[i + 1];
    };
    for (int row = 0; row < FlankStrip::kRows; ++row) {
      const double off = shear * (FlankStrip::kFirstRow_px + row * FlankStrip::kRowStep_px);
      for (int i = 0; i < kLeft; ++i) {
        strips.left.sides[side].push_back(
            static_cast<float>(0.5 + at(100.0 + 30.0 * row + 2.0 * i)));
      }
      for (int i = 0; i < kRight; ++i) {
        strips.right.sides[swapped ? 1 - side : side].push_back(
            static_cast<float>(0.2 + 0.5 * at(100.0 + 30.0 * row + i - kPlace - off)));
      }
    }
  }
  return strips;
}

std::vector<int> all_columns() {
  std::vector<int> columns(kLeft);
  std::iota(columns.begin(), columns.end(), 0);
  return columns;
}

std::vector<double> places_from(double first) {
  std::vector<double> places;
  places.reserve(kLeft);
  for (int i = 0; i < kLeft; ++i) places.push_back(first + 2.0 * i);
  return places;
}

TEST(StripCorrelation, IsOneWhereBothStripsShowTheSameUnderAnotherGain) {
  const StripCorrelation strips(make_strips(), all_columns(), false, 0.25);
  for (const std::size_t side : {0U, 1U}) {
    EXPECT_GT(strips.level(side, places_from(kPlace)), kCorrelated);
    EXPECT_LT(strips.best(side, places_from(kPlace + 12.0)), kChance);
    EXPECT_LT(strips.best(side, places_from(kPlace - 30.0)), kChance);
  }
}

TEST(StripCorrelation, FollowsASideThatFallsAway) {
  constexpr double kParallax = 0.5;
  constexpr double kSlope = 0.8;                     // of those that are tried
  constexpr double kShear = kSlope * kParallax * 2;  // in half pixels per pixel
  constexpr double kInterpolated = 0.95;             // between samples as rough as these
  const StripCorrelation strips(make_strips(kShear), all_columns(), false, kParallax);
  EXPECT_GT(strips.best(0, places_from(kPlace)), kInterpolated);
  EXPECT_LT(strips.level(0, places_from(kPlace)), 0.9 * strips.best(0, places_from(kPlace)));
}

TEST(StripCorrelation, ComparesTheSameSideOfAxesThatRunOppositeWays) {
  const StripCorrelation strips(make_strips(0.0, true), all_columns(), true, 0.25);
  EXPECT_GT(strips.level(0, places_from(kPlace)), kCorrelated);
}

TEST(StripCorrelation, CountsOnlyWhatTheRightImageShows) {
  FlankStrips cut = make_strips();
  const int border = static_cast<int>(kPlace) + 80;  // shows 40 of 60 samples
  for (std::vector<float>& side : cut.right.sides) {
    for (int row = 0; row < FlankStrip::kRows; ++row) {
      for (int i = border; i < kRight; ++i) {
        side[static_cast<std::size_t>(row) * kRight + static_cast<std::size_t>(i)] =
            std::numeric_limits<float>::quiet_NaN();
      }
    }
  }
  const StripCorrelation strips(cut, all_columns(), false, 0.25);
  EXPECT_GT(strips.level(0, places_from(kPlace)), kCorrelated);
  EXPECT_LT(std::abs(strips.level(0, places_from(kPlace + 14.0))), kChance);
  EXPECT_EQ(strips.level(0, places_from(kPlace + 30.0)), 0.0);  // fewer than half
}

TEST(StripCorrelation, IsNoneWithoutTexture) {
  FlankStrips plain = make_strips();
  for (std::vector<float>& side : plain.left.sides) side.assign(side.size(), 0.5F);
  const StripCorrelation strips(plain, all_columns(), false, 0.25);
  EXPECT_EQ(strips.best(0, places_from(kPlace)), 0.0);
}

}  // namespace
}  // namespace ridgeline::reconstruct
