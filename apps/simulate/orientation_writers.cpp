// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/orientation_writers.h"

#include "io/crs/crs.h"

#include <fmt/format.h>

namespace ridgeline::simulate {

std::string camera_file_text(const io::Orientation& orientation) {
  std::string text;
  for (const io::Camera& camera : orientation.cameras) {
    const Eigen::Vector2i& size = *camera.interior.size_px;
    const double side_px = size.maxCoeff();
    const Eigen::Vector2d offset = principal_offset_px(camera.interior) / side_px;
    text += fmt::format(
        "{}:\n  type: pinhole\n  im_size: [{}, {}]\n  focal_len: {}\n  cx: {}\n  cy: {}\n",
        camera.name, size.x(), size.y(), camera.interior.focal_length_px.x() / side_px, offset.x(),
        offset.y());
  }
  return text;
}

std::string wkt_text(const io::Orientation& orientation) {
  return orientation.crs.known() ? io::to_wkt(orientation.crs) : "";
}

const std::string& camera_name(const io::Orientation& orientation, const io::OrientedImage& image) {
  return orientation.cameras[*image.camera].name;
}

Eigen::Vector2d principal_offset_px(const InteriorOrientation& interior) {
  return interior.principal_point_px -
         0.5 * (interior.size_px->cast<double>() - Eigen::Vector2d::Ones());
}

Eigen::Vector2d principal_point_from_corner_px(const InteriorOrientation& interior) {
  return interior.principal_point_px + Eigen::Vector2d::Constant(0.5);
}

Eigen::Matrix3d cam_from_world(const ExteriorOrientation& exterior) {
  const Eigen::Vector3d flip(1.0, -1.0, -1.0);
  return flip.asDiagonal() * exterior.world_from_camera_axes.transpose();
}

std::string row_by_row(const Eigen::Matrix3d& matrix) {
  std::string text;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      text += fmt::format("{}{}", text.empty() ? "" : " ", matrix(row, column));
    }
  }
  return text;
}

}  // namespace ridgeline::simulate
