// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/hierarchical_matching.h"

#include "reconstruct/surface/semi_global.h"
#include "tests/reconstruct/support/rectified_views.h"

#include <gtest/gtest.h>

namespace ridgeline::reconstruct {
namespace {

constexpr int kAllLevels = 2 * kHierarchicalStep;

/// Houses of 60 pixels in front of a slope.
int houses(int x, int y) { return x % 100 > 40 && y % 75 > 15 ? 40 : 12 + x / 40; }

TEST(HierarchicalMatching, FindsWhatTheSearchOfAllDisparitiesFinds) {
  for (const cv::Size& size : {cv::Size(200, 150), cv::Size(203, 149)}) {
    const auto views = test::rectified_views(size, 1, kAllLevels, houses);
    const cv::Mat found = hierarchical_disparities(views.left, views.right, kAllLevels);
    const cv::Mat expected =
        semi_global_disparities(views.left, views.right, all_disparities(size, kAllLevels));
    const cv::Mat known = expected >= 0.0;
    EXPECT_GT(cv::countNonZero(known), 0.8 * size.area());
    EXPECT_LT(cv::countNonZero(known & (cv::abs(found - expected) > 0.1)), 0.03 * size.area());
    EXPECT_GT(cv::countNonZero(found >= 0.0), 0.8 * size.area());
  }
}

TEST(HierarchicalMatching, TakesSmallViews) {
  for (const cv::Size& size : {cv::Size(63, 33), cv::Size(64, 64), cv::Size(31, 200)}) {
    const auto views = test::rectified_views(size, 3, kAllLevels, [](int, int) { return 21; });
    const cv::Mat found = hierarchical_disparities(views.left, views.right, kAllLevels);
    EXPECT_GT(cv::countNonZero(cv::abs(found - 21.0) < 0.4), 0.9 * size.area()) << size;
  }
  for (const cv::Size& size : {cv::Size(1, 1), cv::Size(200, 1), cv::Size(1, 200)}) {
    const auto views = test::rectified_views(size, 3, kAllLevels, [](int, int) { return 21; });
    EXPECT_EQ(hierarchical_disparities(views.left, views.right, kAllLevels).size(), size);
  }
}

TEST(HierarchicalMatching, TakesTheFewestDisparities) {
  const cv::Size size(150, 100);
  const auto views =
      test::rectified_views(size, 1, kHierarchicalStep, [](int x, int) { return x < 75 ? 3 : 28; });
  const cv::Mat found = hierarchical_disparities(views.left, views.right, kHierarchicalStep);
  EXPECT_GT(cv::countNonZero(cv::abs(found.colRange(0, 60) - 3.0) < 0.4), 0.9 * 60 * 100);
  EXPECT_GT(cv::countNonZero(cv::abs(found.colRange(90, 150) - 28.0) < 0.4), 0.9 * 60 * 100);
}

TEST(HierarchicalMatching, KnowsNothingWhereThereIsNothingToMatch) {
  const cv::Mat left(150, 200, CV_8U, cv::Scalar(90));
  const cv::Mat right(150, 200 + kAllLevels, CV_8U, cv::Scalar(90));
  EXPECT_EQ(cv::countNonZero(hierarchical_disparities(left, right, kAllLevels) >= 0.0), 0);
}

}  // namespace
}  // namespace ridgeline::reconstruct
