// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/figure_frame.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace ridgeline::apps {
namespace {

const cv::Scalar kRed(0.0, 0.0, 255.0);
const cv::Scalar kPicture(10.0, 200.0, 90.0);

int count_of(const cv::Mat& page, const cv::Scalar& colour) {
  cv::Mat mask;
  cv::inRange(page, colour, colour, mask);
  return cv::countNonZero(mask);
}

/// Columns of the row that is darkest below the picture, from its first to its last dark pixel: the
/// scale bar.
int bar_length_px(const cv::Mat& page, int first_row) {
  int longest = 0;
  for (int r = first_row; r < page.rows; ++r) {
    int run = 0;
    for (int c = 0; c < page.cols; ++c) {
      run = page.at<cv::Vec3b>(r, c)[1] < 100 ? run + 1 : 0;
      longest = std::max(longest, run);
    }
  }
  return longest;
}

TEST(ScaleBar, IsTheLongestOfOneTwoAndFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(scale_bar_m(10.0), 10.0);
  EXPECT_DOUBLE_EQ(scale_bar_m(9.99), 5.0);
  EXPECT_DOUBLE_EQ(scale_bar_m(4.99), 2.0);
  EXPECT_DOUBLE_EQ(scale_bar_m(1.99), 1.0);
  EXPECT_DOUBLE_EQ(scale_bar_m(0.3), 0.2);
  EXPECT_DOUBLE_EQ(scale_bar_m(712.0), 500.0);
}

TEST(FramedFigure, KeepsThePictureWholeAndAddsTitleLegendAndScale) {
  const cv::Mat picture(300, 800, CV_8UC3, kPicture);
  const cv::Mat bare = framed(picture, {.title = "Lines"});
  const cv::Mat page = framed(
      picture,
      {.title = "Lines", .legend = {{LegendMark::kLine, {kRed}, "aligned"}}, .px_per_m = 12.5});
  EXPECT_EQ(page.cols, picture.cols);
  EXPECT_EQ(count_of(page, kPicture), 300 * 800);
  EXPECT_GT(count_of(page, kRed), 10);
  EXPECT_EQ(count_of(bare, kRed), 0);
  EXPECT_GT(page.rows, bare.rows);
}

TEST(FramedFigure, BarIsAsLongAsItSays) {
  // at most a fifth of the width: 160 px or 12.8 m, so 10 m
  const cv::Mat picture(300, 800, CV_8UC3, kPicture);
  const cv::Mat page = framed(picture, {.title = "", .px_per_m = 12.5});
  constexpr int kWidthOfStrokes_px = 4;
  EXPECT_NEAR(bar_length_px(page, page.rows - 30), 125, kWidthOfStrokes_px);
}

TEST(FramedFigure, LegendOfANarrowPictureTakesMoreRows) {
  const std::vector<LegendEntry> legend{
      {LegendMark::kLine, {kRed}, "aligned with the epipolar line"},
      {LegendMark::kPoints, {kRed}, "points of a plane"},
      {LegendMark::kDashedLine, {kRed}, "false"}};
  const auto rows_beside_picture = [&](int width_px) {
    const cv::Mat picture(50, width_px, CV_8UC3, kPicture);
    return framed(picture, {.title = "Matches", .legend = legend}).rows - picture.rows;
  };
  EXPECT_GT(rows_beside_picture(300), rows_beside_picture(560));
}

}  // namespace
}  // namespace ridgeline::apps
