// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/shift_cause.h"

#include "io/crs/geoid.h"
#include "reconstruct/geometry/epipolar.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace ridgeline::results {
namespace {

using evaluate::ConstantShift;
using evaluate::ShiftAxis;

/// For smaller shifts, a missing geoid grid is not mentioned: the geoid is farther from the
/// ellipsoid nearly everywhere.
constexpr double kMinGeoidShift_m = 1.0;

double half_width_m(const ShiftAxis& axis) { return 0.5 * (axis.ci95_m->high - axis.ci95_m->low); }

/// Whether the shift of the axis is compatible with the expected one but not with zero.
bool is_explained(const ShiftAxis& axis, double expected_m, double tolerance_m) {
  const double allowed_m = half_width_m(axis) + tolerance_m;
  return std::abs(*axis.shift_m - expected_m) <= allowed_m && std::abs(*axis.shift_m) > allowed_m;
}

std::string geoid_cause(const ConstantShift& shift, const ShiftPlace& place) {
  const ShiftAxis& height = shift.axes[2];
  if (!height.shift_m || std::abs(*height.shift_m) <= half_width_m(height) + shift.accuracy_m) {
    return "";
  }
  const bool is_large = std::abs(*height.shift_m) >= kMinGeoidShift_m;
  if (!place.crs.known()) {
    return is_large
               ? "the geoid cannot be compared, as no reference system is stated (`assume_crs`)"
               : "";
  }
  const Eigen::Vector3d position =
      place.frame.world_from_local(place.x_in_local).cwiseQuotient(place.unit_m);
  const io::GeoidAnswer geoid = io::geoid_at(place.crs, position.head<2>(), place.geoid_path);
  if (geoid.height) {
    const auto& [height_m, grid, accuracy_m] = *geoid.height;
    for (const double sign : {1.0, -1.0}) {
      if (!is_explained(height, sign * height_m, accuracy_m)) continue;
      return fmt::format(
          "geoid and ellipsoid: the geoid is {:.2f} m {} the ellipsoid here (grid {}); the lines "
          "seem to have heights above the {} and the cloud heights above the {}",
          std::abs(height_m), height_m < 0.0 ? "below" : "above", grid,
          sign > 0.0 ? "ellipsoid" : "geoid", sign > 0.0 ? "geoid" : "ellipsoid");
    }
  }
  if (!is_large || geoid.missing.empty()) return "";
  return fmt::format(
      "{}PROJ lacks the grid {}; `geoid` names one",
      geoid.height ? "" : "the geoid cannot be compared: ", fmt::join(geoid.missing, ", "));
}

/// The displacement in plan on the ground for half a pixel to the right and down in an image.
Eigen::Vector2d half_pixel_m(const ProjectionMatrix& camera, const Eigen::Vector3d& x) {
  const Plane3 level(Eigen::Vector3d::UnitZ(), -x.z());
  const Eigen::Vector2d moved_px = project(camera, x) + Eigen::Vector2d(0.5, 0.5);
  return (point_on_plane(camera, moved_px, level) - x).head<2>();
}

/// Half a pixel on the ground if it agrees within a quarter for all cameras; else std::nullopt.
std::optional<Eigen::Vector2d> common_half_pixel_m(const ShiftPlace& place) {
  constexpr double kAlike = 0.25;
  const std::vector<io::PatchImage>& images = (*place.patch)->images;
  if (images.empty()) return std::nullopt;
  const auto of = [&](const io::PatchImage& image) {
    return half_pixel_m(image_from_local(image.image_from_world, place.frame.origin_m),
                        place.x_in_local);
  };
  const Eigen::Vector2d first = of(images.front());
  const bool alike = std::ranges::all_of(images, [&](const io::PatchImage& image) {
    return (of(image) - first).norm() <= kAlike * first.norm();
  });
  return alike ? std::optional(first) : std::nullopt;
}

std::string half_pixel_cause(const ConstantShift& shift, const ShiftPlace& place) {
  if (place.patch == nullptr || !*place.patch) return "";
  const auto& [x, y, z] = shift.axes;
  if (!x.shift_m || !y.shift_m || !z.shift_m) return "";
  if (std::abs(*z.shift_m) > half_width_m(z) + shift.accuracy_m) return "";
  const std::optional<Eigen::Vector2d> half_m = common_half_pixel_m(place);
  if (!half_m) return "";
  for (const double sign : {1.0, -1.0}) {
    const Eigen::Vector2d expected_m = sign * *half_m;
    if (!is_explained(x, expected_m.x(), 0.0) || !is_explained(y, expected_m.y(), 0.0)) continue;
    return fmt::format(
        "half a pixel: it is ({:.3f}, {:.3f}) m in plan here, as if pixel (0, 0) were the corner "
        "of the top-left pixel for the cameras and its centre for the images, or vice versa",
        expected_m.x(), expected_m.y());
  }
  return "";
}

}  // namespace

std::string likely_cause(const ConstantShift& shift, const ShiftPlace& place) {
  if (!shift.is_significant()) return "";
  const std::string geoid = geoid_cause(shift, place);
  return geoid.empty() ? half_pixel_cause(shift, place) : geoid;
}

}  // namespace ridgeline::results
