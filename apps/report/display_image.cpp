// SPDX-License-Identifier: BSD-3-Clause
#include "apps/report/display_image.h"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <vector>

namespace ridgeline::apps {

cv::Mat display_image(const cv::Mat& normalised) {
  constexpr double kMaxPixels = 1.2e6;
  std::vector<cv::Mat> bands;
  cv::split(normalised, bands);
  const std::size_t last = bands.size() < 3 ? 0 : 2;
  cv::Mat picture;
  cv::merge(std::vector<cv::Mat>{bands[last], bands[last / 2], bands[0]}, picture);
  picture.convertTo(picture, CV_8UC3, 255.0);
  const double shrink = std::sqrt(kMaxPixels / static_cast<double>(picture.total()));
  if (shrink < 1.0) cv::resize(picture, picture, {}, shrink, shrink, cv::INTER_AREA);
  return picture;
}

}  // namespace ridgeline::apps
