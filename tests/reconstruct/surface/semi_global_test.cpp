// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/surface/semi_global.h"

#include "tests/reconstruct/support/rectified_views.h"

#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

#include <algorithm>

namespace ridgeline::reconstruct {
namespace {

constexpr int kAllPaths = 32;
const cv::Size kPathSize(120, 90);
constexpr double kPart_px = 0.4;  // the parabola through the costs of white noise is not exact

constexpr double kRounded_px = 0.1;  // OpenCV rounds to sixteenths, towards zero

/// A square in front of a slope.
int square(int x, int y) { return x > 40 && x < 80 && y > 20 && y < 60 ? 22 : 6 + y / 20; }

cv::Mat found_with(const test::RectifiedViews& views, const DisparityRanges& ranges) {
  return semi_global_disparities(views.left, views.right, ranges);
}

/// What OpenCV finds, in pixels.
cv::Mat found_by_opencv(const test::RectifiedViews& views) {
  const int block = 25 * views.left.channels();
  cv::Mat left;  // OpenCV gives nothing for the first columns
  cv::copyMakeBorder(views.left, left, 0, 0, kAllPaths, 0, cv::BORDER_CONSTANT);
  cv::Mat sixteenths;
  cv::StereoSGBM::create(0, kAllPaths, 5, 8 * block, 32 * block, 1, 63, 5, 0, 0,
                         cv::StereoSGBM::MODE_HH)
      ->compute(left, views.right, sixteenths);
  cv::Mat found;
  sixteenths.colRange(kAllPaths, left.cols).convertTo(found, CV_32F, 1.0 / 16.0);
  return found;
}

TEST(SemiGlobal, FindsTheDisparitiesOfViewsWithoutNoise) {
  for (const int n_bands : {1, 3}) {
    const auto views =
        test::rectified_views(kPathSize, n_bands, kAllPaths, [](int, int) { return 13; });
    const cv::Mat found = found_with(views, all_disparities(kPathSize, kAllPaths));
    EXPECT_EQ(cv::countNonZero(cv::abs(found - 13.0) > kPart_px), 0) << n_bands;
  }
}

TEST(SemiGlobal, FindsWhatOpenCvFinds) {
  for (const int n_bands : {1, 3}) {
    auto views = test::rectified_views(kPathSize, n_bands, kAllPaths, square);
    views.left += test::texture(kPathSize, n_bands, 3) / 8;  // noise
    const cv::Mat found = found_with(views, all_disparities(kPathSize, kAllPaths));
    const cv::Mat expected = found_by_opencv(views);
    const cv::Mat both = (found >= 0.0) & (expected >= 0.0);
    EXPECT_GT(cv::countNonZero(both), 0.8 * kPathSize.area());
    EXPECT_LT(cv::countNonZero((found >= 0.0) ^ (expected >= 0.0)), 0.01 * kPathSize.area());
    cv::Mat off_px;
    cv::Mat(cv::abs(found - expected)).copyTo(off_px, both);
    const cv::Rect inside(12, 12, kPathSize.width - 24,
                          kPathSize.height - 24);  // OpenCV's border differs
    EXPECT_LT(cv::countNonZero(off_px(inside) > kRounded_px), 0.002 * kPathSize.area());
  }
}

TEST(SemiGlobal, SearchesTheRangesOfTheCells) {
  const auto views = test::rectified_views(kPathSize, 1, kAllPaths, [](int, int) { return 13; });
  DisparityRanges ranges = all_disparities(kPathSize, kAllPaths);
  std::ranges::fill(ranges.of_cells, DisparityRange{8, 16});
  for (int row = 0; row < ranges.cells.height; ++row)  // paths meet other ranges in every direction
    ranges.of_cells[static_cast<std::size_t>(row * ranges.cells.width + 3)] = {8 - 8 * (row % 2),
                                                                               24};
  const cv::Mat found = found_with(views, ranges);
  EXPECT_EQ(cv::countNonZero(cv::abs(found - 13.0) > kPart_px), 0);
}

TEST(SemiGlobal, CarriesDisparitiesIntoOtherRanges) {
  const auto views = test::rectified_views(kPathSize, 1, kAllPaths, [](int, int) { return 13; });
  const cv::Rect plain(40, 20, 40, 40);  // only paths from around tell the disparity here
  views.left(plain).setTo(90);
  views.right(plain + cv::Point(kAllPaths - 13, 0)).setTo(90);
  DisparityRanges ranges = all_disparities(kPathSize, kAllPaths);
  for (std::size_t cell = 0; cell < ranges.of_cells.size(); ++cell)
    ranges.of_cells[cell] =
        cell % 3 == 0 ? DisparityRange{8, 16} : DisparityRange{0, cell % 2 == 0 ? 24 : 32};
  const cv::Mat found = found_with(views, ranges);
  EXPECT_EQ(cv::countNonZero(cv::abs(found(plain) - 13.0) > kPart_px), 0);
}

TEST(SemiGlobal, KnowsNothingInEmptyRanges) {
  const auto views = test::rectified_views(kPathSize, 1, kAllPaths, [](int, int) { return 13; });
  DisparityRanges ranges = all_disparities(kPathSize, kAllPaths);
  ranges.of_cells[static_cast<std::size_t>(2 * ranges.cells.width + 3)] = {};
  const cv::Mat found = found_with(views, ranges);
  const cv::Rect hole(3 * 16, 2 * 16, 16, 16);
  EXPECT_EQ(cv::countNonZero(found(hole) >= 0.0), 4);  // the median closes corners
  EXPECT_EQ(cv::countNonZero(cv::abs(found - 13.0) < kPart_px), kPathSize.area() - hole.area() + 4);
  const cv::Mat none = found_with(views, all_disparities(kPathSize, 0));
  EXPECT_EQ(cv::countNonZero(none >= 0.0), 0);
}

TEST(SemiGlobal, TakesTheLargestContrasts) {
  cv::Mat left(kPathSize, CV_8UC3);
  for (int x = 0; x < kPathSize.width; ++x)
    left.col(x).setTo(cv::Scalar::all(x % 2 == 0 ? 255.0 : 0.0));
  cv::Mat right(kPathSize.height, kPathSize.width + kAllPaths, CV_8UC3, cv::Scalar(0, 0, 0));
  EXPECT_EQ(found_with({left, right}, all_disparities(kPathSize, kAllPaths)).size(), kPathSize);
}

TEST(SemiGlobal, TakesTinyViews) {
  for (const cv::Size& size : {cv::Size(1, 1), cv::Size(1, 40), cv::Size(40, 1), cv::Size(17, 3)}) {
    const auto views = test::rectified_views(size, 3, kAllPaths, [](int, int) { return 13; });
    EXPECT_EQ(found_with(views, all_disparities(size, kAllPaths)).size(), size);
  }
}

}  // namespace
}  // namespace ridgeline::reconstruct
