// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/disparity_ranges.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <algorithm>

namespace ridgeline::reconstruct {
namespace {

constexpr int kAllNear = 64;
const cv::Size kFineSize(160, 96);
const cv::Size kCoarseSize(80, 48);

bool holds(const DisparityRange& range, int disparity) {
  return range.first <= disparity && disparity < range.first + range.n;
}

void expect_valid(const DisparityRanges& ranges) {
  for (const DisparityRange& range : ranges.of_cells) {
    EXPECT_EQ(range.n % DisparityRange::kStep, 0);
    EXPECT_GE(range.first, 0);
    EXPECT_LE(range.first + range.n, ranges.n_all);
  }
}

TEST(AllDisparities, AreThoseOfEveryCell) {
  const DisparityRanges ranges = all_disparities({33, 16}, kAllNear);
  EXPECT_EQ(ranges.cells, cv::Size(3, 1));
  ASSERT_EQ(ranges.of_cells.size(), 3U);
  EXPECT_EQ(ranges.at(32, 15), (DisparityRange{0, kAllNear}));
}

TEST(DisparitiesNear, AreAFewAroundTheCoarseOne) {
  const auto ranges =
      disparities_near(cv::Mat(kCoarseSize, CV_32F, cv::Scalar(10.25)), kFineSize, kAllNear);
  expect_valid(ranges);
  for (const DisparityRange& range : ranges.of_cells) {
    for (const int d : {16, 20, 21, 26}) EXPECT_TRUE(holds(range, d)) << d;
    EXPECT_LE(range.n, 16);
  }
}

TEST(DisparitiesNear, AreThoseOfBothSidesAtAStepOnly) {
  cv::Mat coarse(kCoarseSize, CV_32F, cv::Scalar(5.0));
  coarse.colRange(40, 80).setTo(25.0);
  const auto ranges = disparities_near(coarse, kFineSize, kAllNear);
  expect_valid(ranges);
  for (const int x : {79, 80}) {
    EXPECT_TRUE(holds(ranges.at(x, 40), 10)) << x;
    EXPECT_TRUE(holds(ranges.at(x, 40), 50)) << x;
  }
  EXPECT_FALSE(holds(ranges.at(20, 40), 50));
  EXPECT_FALSE(holds(ranges.at(140, 40), 10));
}

TEST(DisparitiesNear, StayWithinAll) {
  for (const int n_all : {8, kAllNear}) {
    for (const int coarse : {0, n_all / 2 - 1}) {
      const auto ranges =
          disparities_near(cv::Mat(kCoarseSize, CV_32F, cv::Scalar(coarse)), kFineSize, n_all);
      expect_valid(ranges);
      EXPECT_TRUE(holds(ranges.at(0, 0), 2 * coarse)) << n_all;
    }
  }
}

TEST(DisparitiesNear, ComeFromFartherAwayWhereTheCoarseImageKnowsLittle) {
  cv::Mat coarse(kCoarseSize, CV_32F, cv::Scalar(10.0));
  coarse(cv::Rect(30, 0, 20, 48)).setTo(-1.0);
  const auto ranges = disparities_near(coarse, kFineSize, kAllNear);
  EXPECT_TRUE(holds(ranges.at(80, 48), 20));
}

TEST(DisparitiesNear, AreNoneWhereTheCoarseImageKnowsNothing) {
  const auto ranges =
      disparities_near(cv::Mat(kCoarseSize, CV_32F, cv::Scalar(-1.0)), kFineSize, kAllNear);
  for (const DisparityRange& range : ranges.of_cells) EXPECT_EQ(range.n, 0);
}

TEST(DisparitiesNear, AreNoneWhereThereAreTooMany) {
  cv::Mat coarse(kCoarseSize, CV_32F, cv::Scalar(5.0));
  coarse.at<float>(24, 40) = 400.0F;
  const auto ranges = disparities_near(coarse, kFineSize, 1024);
  EXPECT_EQ(ranges.at(80, 48).n, 0);
  EXPECT_TRUE(holds(ranges.at(0, 0), 10));
}

TEST(DisparitiesNear, OfAViewWithOddSidesAreThoseOfItsWholePixels) {
  const auto ranges =
      disparities_near(cv::Mat(cv::Size(16, 8), CV_32F, cv::Scalar(10.0)), {33, 17}, kAllNear);
  EXPECT_EQ(ranges.cells, cv::Size(3, 2));
  for (const DisparityRange& range : ranges.of_cells) EXPECT_TRUE(holds(range, 20));
}

}  // namespace
}  // namespace ridgeline::reconstruct
