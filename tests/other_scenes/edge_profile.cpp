// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/edge_profile.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ridgeline::other {
namespace {

constexpr double kStep_px = 0.25;

/// Bilinear; nothing outside of the image.
std::optional<cv::Vec3d> colour_at(const cv::Mat& image, const Eigen::Vector2d& x) {
  const int column = static_cast<int>(std::floor(x.x()));
  const int row = static_cast<int>(std::floor(x.y()));
  if (column < 0 || row < 0 || column >= image.cols - 1 || row >= image.rows - 1) {
    return std::nullopt;
  }
  const double s = x.x() - column;
  const double t = x.y() - row;
  const auto at = [&](int c, int r) { return cv::Vec3d(image.at<cv::Vec3b>(row + r, column + c)); };
  return (1.0 - t) * ((1.0 - s) * at(0, 0) + s * at(1, 0)) +
         t * ((1.0 - s) * at(0, 1) + s * at(1, 1));
}

/// Mean colour on parallels to the segment, kStep_px apart, from -n to n; empty if one of them lies
/// outside of the image all along.
std::vector<cv::Vec3d> mean_profile(const cv::Mat& image, const Segment2& segment, int n) {
  constexpr double kEnds_px = 2.0, kPitch_px = 0.5;
  const int n_points = static_cast<int>((length(segment) - 2.0 * kEnds_px) / kPitch_px);
  const Eigen::Vector2d along = (segment.end - segment.start).normalized();
  const Eigen::Vector2d across(-along.y(), along.x());
  std::vector<cv::Vec3d> profile;
  for (int i = -n; i <= n; ++i) {
    cv::Vec3d sum(0.0, 0.0, 0.0);
    int count = 0;
    for (int j = 0; j < n_points; ++j) {
      const double t = kEnds_px + kPitch_px * j;
      const auto colour = colour_at(image, segment.start + t * along + i * kStep_px * across);
      if (!colour) continue;
      sum += *colour;
      ++count;
    }
    if (count == 0) return {};
    profile.push_back(sum * (1.0 / count));
  }
  return profile;
}

}  // namespace

std::optional<EdgeProfile> edge_profile(const cv::Mat& image,
                                        const Segment2& segment,
                                        double reach_px) {
  constexpr double kMinLength_px = 20.0;
  constexpr int kHalf = 2;  // of the pixel over which colours are compared, in steps
  if (length(segment) < kMinLength_px) return std::nullopt;
  const int reach = static_cast<int>(reach_px / kStep_px);
  const std::vector<cv::Vec3d> profile = mean_profile(image, segment, reach + kHalf);
  if (profile.empty()) return std::nullopt;
  EdgeProfile strongest;
  for (int i = -reach; i <= reach; ++i) {
    const int middle = i + reach + kHalf;
    const double contrast = cv::norm(profile[middle + kHalf] - profile[middle - kHalf]);
    if (contrast <= strongest.contrast_grey) continue;
    strongest = {i * kStep_px, contrast};
  }
  return strongest;
}

}  // namespace ridgeline::other
