// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/scene/pair_check/point_matches.h"

#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>

namespace ridgeline::reconstruct {
namespace {

struct Features {
  std::vector<cv::KeyPoint> points;  ///< in the reduced image
  cv::Mat descriptors;
  Eigen::Vector2d scale;  ///< pixels of the image per pixel of the reduced image
};

/// A grey image reduced to half its size; small images are reduced less, large ones more. Stronger
/// reduction makes the points less accurate, whereas the run time increases with the number of
/// pixels.
cv::Mat reduced_grey(const cv::Mat& image) {
  constexpr double kMinSide_px = 500.0;
  constexpr double kMaxSide_px = 1500.0;
  const double side_px = std::max(image.cols, image.rows);
  const double factor = std::clamp(0.5 * side_px, kMinSide_px, kMaxSide_px) / side_px;
  cv::Mat small = image;
  if (factor < 1.0) cv::resize(image, small, {}, factor, factor, cv::INTER_AREA);
  cv::Mat mean;
  const cv::Mat weights(1, small.channels(), CV_32F, cv::Scalar(1.0 / small.channels()));
  cv::transform(small, mean, weights);
  cv::Mat grey;
  mean.convertTo(grey, CV_8U, 255.0);
  return grey;
}

Features features_of(const cv::Mat& image) {
  constexpr int kMaxPoints = 1500;  // enough for a median; the run time increases with their square
  const cv::Mat grey = reduced_grey(image);
  Features features;
  cv::SIFT::create(kMaxPoints)->detectAndCompute(grey, {}, features.points, features.descriptors);
  features.scale = {double(image.cols) / grey.cols, double(image.rows) / grey.rows};
  return features;
}

Eigen::Vector2d in_full_image(const Features& features, int i) {
  const cv::Point2f& x = features.points[i].pt;
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5);
  return (Eigen::Vector2d(x.x, x.y) + half).cwiseProduct(features.scale) - half;
}

}  // namespace

std::vector<PointMatch> match_points(const std::array<cv::Mat, 2>& images) {
  constexpr float kRatio =
      0.75F;  // between Lowe's 0.8 and the stricter values for repeated texture
  const Features left = features_of(images[0]);
  const Features right = features_of(images[1]);
  if (left.points.size() < 2 || right.points.size() < 2) return {};
  const cv::BFMatcher matcher(cv::NORM_L2);
  std::vector<std::vector<cv::DMatch>> two_best;
  matcher.knnMatch(left.descriptors, right.descriptors, two_best, 2);
  std::vector<cv::DMatch> back;
  matcher.match(right.descriptors, left.descriptors, back);
  std::vector<PointMatch> matches;
  for (const std::vector<cv::DMatch>& best : two_best) {
    if (best[0].distance > kRatio * best[1].distance) continue;
    if (back[best[0].trainIdx].trainIdx != best[0].queryIdx) continue;
    matches.push_back(
        {{in_full_image(left, best[0].queryIdx), in_full_image(right, best[0].trainIdx)}});
  }
  return matches;
}

}  // namespace ridgeline::reconstruct
