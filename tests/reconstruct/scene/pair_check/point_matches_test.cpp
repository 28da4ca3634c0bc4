// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/scene/pair_check/point_matches.h"

#include <gmock/gmock.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace ridgeline::reconstruct {
namespace {

constexpr int kSide_px = 900;
// SIFT is exact to about half a pixel of images that are reduced to 500 pixels.
constexpr double kPixel_px = 2.0;
constexpr std::size_t kMinMatches = 100;
constexpr double kMinRightShare = 0.9;

/// Blots of many sizes, so that no two places look the same. CV_32FC3 in [0, 1].
cv::Mat blots(int seed) {
  cv::RNG random(seed);
  cv::Mat image(kSide_px, kSide_px, CV_32FC3, cv::Scalar::all(0.5));
  for (int i = 0; i < 3000; ++i) {
    const cv::Point centre(random.uniform(0, kSide_px), random.uniform(0, kSide_px));
    const cv::Size axes(random.uniform(2, 25), random.uniform(2, 25));
    const cv::Scalar colour(random.uniform(0.0, 1.0), random.uniform(0.0, 1.0),
                            random.uniform(0.0, 1.0));
    cv::ellipse(image, centre, axes, random.uniform(0, 180), 0, 360, colour, cv::FILLED);
  }
  cv::GaussianBlur(image, image, {}, 1.0);
  return image;
}

/// Share of the matches whose right point is where `expected` has the left one.
template <typename Map>
double share_right(const std::vector<PointMatch>& matches, const Map& expected) {
  const auto n = std::ranges::count_if(matches, [&](const PointMatch& match) {
    return (match.x_px[1] - expected(match.x_px[0])).norm() < kPixel_px;
  });
  return double(n) / double(matches.size());
}

TEST(MatchPoints, FindsThePlaceInAShiftedImage) {
  const cv::Mat image = blots(1);
  const cv::Mat left = image(cv::Rect(40, 30, 800, 800));
  const auto matches = match_points({left.clone(), image});
  ASSERT_GT(matches.size(), kMinMatches);
  EXPECT_GT(share_right(matches,
                        [](const Eigen::Vector2d& x) {
                          return Eigen::Vector2d(x + Eigen::Vector2d(40, 30));
                        }),
            kMinRightShare);
}

TEST(MatchPoints, FindsThePlaceInATurnedAndInAReducedImage) {
  const cv::Mat image = blots(2);
  cv::Mat turned;
  cv::rotate(image, turned, cv::ROTATE_180);
  const auto of_turned = match_points({image, turned});
  ASSERT_GT(of_turned.size(), kMinMatches);
  EXPECT_GT(share_right(of_turned,
                        [](const Eigen::Vector2d& x) {
                          return Eigen::Vector2d(Eigen::Vector2d::Constant(kSide_px - 1) - x);
                        }),
            kMinRightShare);
  cv::Mat half;
  cv::resize(image, half, {}, 0.5, 0.5, cv::INTER_AREA);
  const auto of_half = match_points({image, half});
  ASSERT_GT(of_half.size(), kMinMatches);
  EXPECT_GT(share_right(of_half,
                        [](const Eigen::Vector2d& x) {
                          const Eigen::Vector2d edge = Eigen::Vector2d::Constant(0.5);
                          return Eigen::Vector2d(0.5 * (x + edge) - edge);
                        }),
            kMinRightShare);
}

TEST(MatchPoints, FindsNextToNothingInImagesOfDifferentPlacesAndNothingWithoutTexture) {
  EXPECT_LT(match_points({blots(3), blots(4)}).size(), kMinMatches / 4);
  const cv::Mat grey(300, 400, CV_32FC1, cv::Scalar(0.4));
  EXPECT_TRUE(match_points({grey, grey}).empty());
  const cv::Mat pixel(2, 2, CV_32FC1, cv::Scalar(0.4));
  EXPECT_TRUE(match_points({pixel, pixel}).empty());
}

TEST(MatchPoints, GivesTheSameTwice) {
  const std::array<cv::Mat, 2> images{blots(5), blots(5)};
  const auto once = match_points(images);
  const auto again = match_points(images);
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_EQ(once[i].x_px, again[i].x_px);
}

}  // namespace
}  // namespace ridgeline::reconstruct
