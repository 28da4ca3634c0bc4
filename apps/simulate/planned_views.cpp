// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/planned_views.h"

#include "reconstruct/geometry/degrees.h"
#include "reconstruct/geometry/orientation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ridgeline::simulate {
namespace {

/// Distance of view i of a strip from the middle of the strip.
double along_strip_m(const FlightOptions& options, int num_views, int i) {
  const double base_m = options.base_to_height * options.height_above_ground_m;
  return (i - 0.5 * (num_views - 1)) * base_m;
}

/// Aims a view at the middle of the plan; the azimuth is that of the camera as seen from there.
void aim_oblique(const FlightOptions& options, double azimuth_rad, PlannedView& view) {
  const double tilt_rad = kRadPerDeg * options.oblique_tilt_deg;
  const Eigen::Vector3d to_camera{std::sin(tilt_rad) * std::sin(azimuth_rad),
                                  std::sin(tilt_rad) * std::cos(azimuth_rad), std::cos(tilt_rad)};
  view.from_middle_m = options.height_above_ground_m * to_camera;
  // a camera tilted about its rows is at -y and looks towards +y; then it is rotated to its azimuth
  view.world_from_camera_axes = world_from_camera_axes(0.0, 0.0, std::numbers::pi - azimuth_rad) *
                                world_from_camera_axes(tilt_rad, 0.0, 0.0);
}

PlannedView planned_view(const FlightOptions& options, const ViewGroup& group, int i) {
  constexpr double kFirstAzimuthRad = std::numbers::pi / 4.0;
  // so that no view of the strip along y coincides with one of the strip along x
  constexpr double kCrossShiftBases = 0.25;
  const double along_m = along_strip_m(options, group.num_views, i);
  const double height_m = options.height_above_ground_m;
  PlannedView view;
  switch (group.kind) {
    case ViewGroupKind::kStrip:
      view.from_middle_m = {along_m, 0.0, height_m};
      break;
    case ViewGroupKind::kCross:
      view.from_middle_m = {kCrossShiftBases * options.base_to_height * height_m, along_m,
                            height_m};
      view.world_from_camera_axes = world_from_camera_axes(0.0, 0.0, 0.5 * std::numbers::pi);
      break;
    case ViewGroupKind::kOblique:
      aim_oblique(options, kFirstAzimuthRad + 2.0 * std::numbers::pi * i / group.num_views, view);
      break;
  }
  return view;
}

/// The view of a group that is nearest to the middle of the plan; oblique views are all equally
/// distant.
int base_of(const ViewGroup& group) {
  return group.kind == ViewGroupKind::kOblique ? 0 : (group.num_views - 1) / 2;
}

}  // namespace

std::vector<PlannedView> planned_views(const FlightOptions& options) {
  check_view_groups(options.groups);
  std::vector<PlannedView> views;
  for (const ViewGroup& group : options.groups) {
    for (int i = 0; i < group.num_views; ++i) {
      views.push_back(planned_view(options, group, i));
      views.back().id = name(group.kind) + std::to_string(i + 1);
      views.back().number = views.size() - 1;
    }
  }
  if (views.size() == 2) {
    views[0].id = "left";
    views[1].id = "right";
  }
  // the view after the base is its neighbour, because in a group of several views the base is not
  // the last
  const auto base = views.begin() + base_of(options.groups.front());
  std::rotate(views.begin(), base, base + 2);
  return views;
}

}  // namespace ridgeline::simulate
