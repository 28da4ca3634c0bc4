// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/judge/line_to_plane_evaluation.h"
#include "reconstruct/reconstruct.h"

#include <opencv2/imgproc.hpp>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include <iostream>
#include <memory>
#include <vector>

namespace {

/// Looks straight down from a height of 400 m.
ridgeline::ProjectionMatrix camera_at(double x) {
  ridgeline::ProjectionMatrix p;
  p << 1000, 0, -200, 200 * 400 - 1000 * x, 0, -1000, -200, 200 * 400, 0, 0, -1, 400;
  return p;
}

/// A flat roof at a height of 270 m.
cv::Mat photograph(const ridgeline::ProjectionMatrix& camera) {
  cv::Mat image(400, 400, CV_8UC1, cv::Scalar(60));
  const auto pixel = [&](double x, double y) {
    const Eigen::Vector2d x_px = (camera * Eigen::Vector3d(x, y, 270).homogeneous()).hnormalized();
    return cv::Point(cvRound(x_px.x()), cvRound(x_px.y()));
  };
  cv::rectangle(image, pixel(-8, 8), pixel(8, -8), cv::Scalar(200), cv::FILLED);
  cv::GaussianBlur(image, image, {}, 0.7);
  return image;
}

}  // namespace

int main() {
  const auto cloud = std::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  for (float x = -8; x <= 8; x += 0.4F) {
    for (float y = -8; y <= 8; y += 0.4F) cloud->emplace_back(x, y, 5.0F);
  }
  std::vector<ridgeline::evaluate::JudgedLine> lines(1);
  lines.front().id = "eave";
  lines.front().segment = {{-8, -8, 5.1}, {8, -8, 5.1}};
  const ridgeline::ProjectionMatrix left_camera = camera_at(-15), right_camera = camera_at(15);
  const cv::Mat left_image = photograph(left_camera), right_image = photograph(right_camera);
#include "readme_example.inc"
}
