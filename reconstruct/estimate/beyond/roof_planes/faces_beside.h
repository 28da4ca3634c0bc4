// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/roof_planes/plane_faces.h"
#include "reconstruct/estimate/ok2011/reconstruct_lines.h"
#include "reconstruct/surface/rectification.h"

namespace ridgeline::reconstruct {

/// Adjusts a line to the plane faces that it borders: eaves and verges to one, ridges, hips and
/// valleys to two. Faces determine heights better than edges nearly parallel to the base do. Edges
/// determine the position of a line in the image better.
///
/// A face is beside a line if at least half of the points 4 px beside its left segment are in it.
/// Such a face gives two conditions: both ends lie on its plane, in disparities of the rectified
/// left view. The sigma of the conditions has a part of 0.3 px that is common to both ends
/// (gutters, and steps that the matching fattens) and a part of 0.1 px for each end. A face that
/// the line contradicts at the 99.9 % level (fences, cars, a street below an eave) is not used. Of
/// two faces, the nearer one is applied first. A line without covariance is left unchanged.
void adjust_to_faces_beside(const Rectification& r,
                            const PlaneFaces& faces,
                            ReconstructedLine& line);

/// Disparity of a point minus that of a plane at the pixel where the rectified left view shows the
/// point.
struct PlaneMisfit {
  double value_px = 0.0;
  Eigen::RowVector3d by_point;
  Eigen::RowVector3d by_plane;
};
PlaneMisfit plane_misfit(const Rectification& r,
                         const Eigen::Vector3d& plane,
                         const Eigen::Vector3d& x_in_local);

}  // namespace ridgeline::reconstruct
