// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/roof_planes/plane_faces.h"
#include "reconstruct/estimate/ok2011/reconstruct_lines.h"
#include "reconstruct/surface/rectification.h"

namespace ridgeline::reconstruct {

/// Adjusts a line to the plane faces that it borders: eaves and verges to one, ridges, hips and
/// valleys to two. Faces know heights better than edges that run near the base. Edges know better
/// where a line is in the image.
///
/// A face is beside a line if half of the places 4 px beside its left segment are in it. Such a
/// face gives two conditions: both ends lie on its plane, in disparities of the rectified left
/// view. The conditions hold to 0.3 px that both ends share (gutters and steps that the matching
/// fattens) and to 0.1 px of each end. A face that the line contradicts at 99.9 % (fences, cars, a
/// street below an eave) changes nothing. If there are two faces, the nearer one comes first. A
/// line without covariance stays as it is.
void adjust_to_faces_beside(const Rectification& r,
                            const PlaneFaces& faces,
                            ReconstructedLine& line);

/// How far the disparity of a point is from that of a plane at the pixel where the rectified left
/// view shows the point.
struct PlaneMisfit {
  double value_px = 0.0;
  Eigen::RowVector3d by_point;
  Eigen::RowVector3d by_plane;
};
PlaneMisfit plane_misfit(const Rectification& r,
                         const Eigen::Vector3d& plane,
                         const Eigen::Vector3d& x_in_local);

}  // namespace ridgeline::reconstruct
