// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/estimate/beyond/confirmation.h"

#include <algorithm>
#include <set>

namespace ridgeline::reconstruct {
namespace {

constexpr int kPlacesOfLine = 5;  // number of points tested along a line

/// Whether the ray from a point to a camera passes below the surface.
bool is_hidden(const Surface& surface,
               const Eigen::Vector3d& x_in_local,
               const Eigen::Vector3d& camera_in_local,
               double highest_m) {
  constexpr double kStep_m = 0.5;
  constexpr double kBelow_px = 2.0;  // in disparities; surface errors at edges are smaller
  const Eigen::Vector3d ray = (camera_in_local - x_in_local).normalized();
  if (!(ray.z() > 0.0)) return false;
  const Rectification& r = surface.rectification;
  for (double way_m = 2.0 * kStep_m; x_in_local.z() + way_m * ray.z() < highest_m;
       way_m += kStep_m) {
    const Eigen::Vector3d x = x_in_local + way_m * ray;
    const auto d_px = surface.at(r.rectified(x));
    if (d_px && *d_px > r.disparity_px(x) + kBelow_px) return true;
  }
  return false;
}

bool is_in_image(const View& view, const Eigen::Vector3d& x_in_local) {
  constexpr double kBorder_px = 5.0;  // edges are not found closer to the border
  const Eigen::Vector2d x = project(view.image_from_local, x_in_local);
  return x.x() >= kBorder_px && x.y() >= kBorder_px && x.x() < view.image.cols - kBorder_px &&
         x.y() < view.image.rows - kBorder_px;
}

}  // namespace

bool is_expected(const Scene& scene,
                 std::size_t number,
                 const Segment3& line,
                 std::span<const Surface* const> surfaces) {
  const View& view = scene.views[number];
  if (!is_in_image(view, line.start) || !is_in_image(view, line.end)) return false;
  const Eigen::Vector3d camera = projection_centre(view.image_from_local).hnormalized();
  return std::ranges::none_of(surfaces, [&](const Surface* surface) {
    int n_hidden = 0;
    for (int i = 0; i < kPlacesOfLine; ++i) {
      n_hidden += is_hidden(*surface, point_at(line, (i + 0.5) / kPlacesOfLine), camera,
                            scene.height_range_in_local_m[1]);
    }
    return 2 * n_hidden > kPlacesOfLine;
  });
}

void mark_unconfirmed(const Scene& scene,
                      std::span<const Surface* const> surfaces,
                      std::vector<ReconstructedLine>& lines) {
  for (ReconstructedLine& line : lines) {
    if (!line.segment_in_local) continue;
    std::set<std::size_t> seen;
    for (const ObservedSegment& s : line.observations) seen.insert(s.view);
    if (seen.size() > 2) continue;
    for (std::size_t view = 0; view < scene.views.size(); ++view) {
      if (seen.contains(view) || !is_expected(scene, view, *line.segment_in_local, surfaces))
        continue;
      line.confirmed = false;
      break;
    }
  }
}

}  // namespace ridgeline::reconstruct
