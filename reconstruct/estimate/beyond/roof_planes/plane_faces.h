// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/surface/surface.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <vector>

namespace ridgeline::reconstruct {

/// A plane in the disparities of the rectified left view, d = a x + b y + c, on which many pixels
/// lie.
struct PlaneFace {
  Eigen::Vector3d plane = Eigen::Vector3d::Zero();  ///< a, b, c
  Eigen::Matrix3d cov = Eigen::Matrix3d::Zero();
  int n_cells = 0;

  [[nodiscard]] double disparity_px(const Eigen::Vector2d& x_px) const {
    return plane.dot(x_px.homogeneous());
  }
};

/// The plane faces of a surface and the square cells that belong to each.
struct PlaneFaces {
  static constexpr int kCell_px = 6;
  static constexpr int kNone = -1;
  std::vector<PlaneFace> faces;
  cv::Mat face_of_cell;  ///< CV_32S, by row and column of the cells; kNone if a cell has none

  /// The face that contains a pixel, or kNone.
  [[nodiscard]] int at(const Eigen::Vector2d& x_px) const;

  [[nodiscard]] static Eigen::Vector2d centre_px(int row, int column) {
    return {kCell_px * (column + 0.5) - 0.5, kCell_px * (row + 0.5) - 0.5};
  }
};

/// Grows faces from the most planar cells. A face grows as long as the next cell lies on the plane
/// of the previous cells to within 0.4 px RMS. The plane of a face is then fitted to its inner
/// cells. Faces of fewer than 12 cells or without an inner cell, and surfaces as steep as walls,
/// are left out.
PlaneFaces plane_faces(const Surface& surface);

}  // namespace ridgeline::reconstruct
