// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/roof_planes/faces_beside.h"

#include "reconstruct/geometry/uncertain/homogeneous.h"

#include <Eigen/LU>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {
namespace {

// Sigma of the line's distance from the plane, common to both ends.
constexpr double kShared_px = 0.3;
constexpr double kOwn_px = 0.1;  // additional sigma of each end

using Matrix26d = Eigen::Matrix<double, 2, 6>;

/// The face that contains at least half of the sample points beside a segment.
std::optional<int> face_beside(const PlaneFaces& faces, const Segment2& rectified, double side) {
  constexpr double kBeside_px = 4.0;  // cells crossed by an edge mostly belong to no face
  constexpr int kMinPlaces = 3;
  const Eigen::Vector2d off = side * kBeside_px * normal(rectified);
  const int n_places =
      std::max(kMinPlaces, static_cast<int>(length(rectified) / PlaneFaces::kCell_px));
  std::map<int, int> votes;
  for (int i = 0; i < n_places; ++i) {
    const int face = faces.at(point_at(rectified, (i + 0.5) / n_places) + off);
    if (face != PlaneFaces::kNone) ++votes[face];
  }
  for (const auto& [face, n] : votes) {
    if (2 * n >= n_places) return face;
  }
  return std::nullopt;
}

/// The faces on both sides of a segment, the nearer one first.
std::vector<const PlaneFace*> faces_beside(const PlaneFaces& faces, const Segment2& rectified) {
  const auto right = face_beside(faces, rectified, 1.0);
  const auto left = face_beside(faces, rectified, -1.0);
  std::vector<const PlaneFace*> beside;
  if (right) beside.push_back(&faces.faces[static_cast<std::size_t>(*right)]);
  if (left && left != right) beside.push_back(&faces.faces[static_cast<std::size_t>(*left)]);
  std::ranges::stable_sort(beside, std::greater{}, [&](const PlaneFace* face) {
    return face->disparity_px(midpoint(rectified));
  });
  return beside;
}

/// Makes one step of the adjustment with both ends as unknowns.
void adjust_to_face(const Rectification& r, const PlaneFace& face, Vector6d& ends, Matrix6d& cov) {
  constexpr double kMaxChiSquare = 13.816;  // chi-square with 2 degrees of freedom, 99.9 %
  Matrix26d by_ends = Matrix26d::Zero();
  Eigen::Matrix<double, 2, 3> by_plane;
  Eigen::Vector2d misfit;
  for (const Eigen::Index end : {0, 1}) {
    const PlaneMisfit at_end = plane_misfit(r, face.plane, ends.segment<3>(3 * end));
    misfit(end) = at_end.value_px;
    by_ends.block<1, 3>(end, 3 * end) = at_end.by_point;
    by_plane.row(end) = at_end.by_plane;
  }
  const Eigen::Matrix2d of_face = propagated(by_plane, face.cov) +
                                  kShared_px * kShared_px * Eigen::Matrix2d::Ones() +
                                  kOwn_px * kOwn_px * Eigen::Matrix2d::Identity();
  const Eigen::Matrix2d weight = (propagated(by_ends, cov) + of_face).inverse();
  if (misfit.dot(weight * misfit) > kMaxChiSquare) return;
  const Eigen::Matrix<double, 6, 2> gain = cov * by_ends.transpose() * weight;
  ends -= gain * misfit;
  const Matrix6d kept = Matrix6d::Identity() - gain * by_ends;
  cov = propagated(kept, cov) + gain * of_face * gain.transpose();
}

}  // namespace

PlaneMisfit plane_misfit(const Rectification& r,
                         const Eigen::Vector3d& plane,
                         const Eigen::Vector3d& x_in_local) {
  const Eigen::Vector3d in_camera = r.rectified_from_local * (x_in_local - r.left_centre_m);
  const double px_per_m = r.focal_px / in_camera.z();
  const Eigen::Vector3d x_px = r.rectified(x_in_local).homogeneous();
  const double d_px = px_per_m * r.base_m;
  const Eigen::Vector2d slope = plane.head<2>();
  Eigen::RowVector3d by_point;
  by_point << -px_per_m * slope.transpose(),
      px_per_m * slope.dot(in_camera.hnormalized()) - d_px / in_camera.z();
  return {d_px - plane.dot(x_px), by_point * r.rectified_from_local, -x_px.transpose()};
}

void adjust_to_faces_beside(const Rectification& r,
                            const PlaneFaces& faces,
                            ReconstructedLine& line) {
  if (!line.segment_in_local || !line.covariance_m2) return;
  Segment3& segment = *line.segment_in_local;
  const Segment3 before = segment;
  Vector6d ends;
  ends << segment.start, segment.end;
  for (const PlaneFace* face :
       faces_beside(faces, {r.rectified(segment.start), r.rectified(segment.end)}))
    adjust_to_face(r, *face, ends, *line.covariance_m2);
  segment = {ends.head<3>(), ends.tail<3>()};
  if (!line.other_segment_in_local) return;
  for (Eigen::Vector3d* end :
       {&line.other_segment_in_local->start, &line.other_segment_in_local->end})
    *end = point_at(segment, parameter_along(before, *end));
}

}  // namespace ridgeline::reconstruct
