// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/scan_scope.h"

#include "evaluate/judge/plan_hull.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/plan_box.h"
#include "reconstruct/geometry/plane.h"
#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

namespace ridgeline::results {
namespace {

using HullCorners = std::vector<Eigen::Vector2d>;

/// An image of known size in the local frame.
struct ScopeImage {
  ProjectionMatrix image_from_local;
  Eigen::Vector2d size_px;

  [[nodiscard]] bool shows(const Eigen::Vector3d& x) const {
    const Eigen::Vector3d in_image = image_from_local * x.homogeneous();
    const double facing = image_from_local.leftCols<3>().determinant();
    if (facing * in_image.z() <= 0.0) return false;
    const Eigen::Array2d px = in_image.hnormalized();
    return (px >= -0.5).all() && (px <= size_px.array() - 0.5).all();
  }
};

/// Columns and rows of the part of an image that is read; 0 if unknown.
Eigen::Vector2i read_size_px(const io::PatchImage& image) {
  if (image.window) return {image.window->width, image.window->height};
  if (image.facts) return turned_size_px(image, *image.facts);
  if (image.interior && image.interior->size_px) return *image.interior->size_px;
  return Eigen::Vector2i::Zero();
}

/// The images of a patch; empty if the size of one is unknown.
std::vector<ScopeImage> scope_images(const std::optional<io::Patch>& patch,
                                     const LocalFrame& frame) {
  std::vector<ScopeImage> images;
  if (!patch) return images;
  for (const io::PatchImage& image : patch->images) {
    const Eigen::Vector2i size_px = read_size_px(image);
    if ((size_px.array() <= 0).any()) return {};
    images.push_back({ridgeline::image_from_local(image.image_from_world, frame.origin_m),
                      size_px.cast<double>()});
  }
  return images;
}

/// The hull of what the corners of an image show at the lowest and the highest object height.
HullCorners shown_ground(const ScopeImage& image, const std::array<double, 2>& heights_m) {
  std::vector<Eigen::Vector2d> shown;
  const Eigen::AlignedBox2d window(Eigen::Vector2d::Constant(-0.5),
                                   image.size_px - Eigen::Vector2d::Constant(0.5));
  for (const double height_m : heights_m) {
    const Plane3 level(Eigen::Vector3d::UnitZ(), -height_m);
    for (const Eigen::Vector2d& corner : corners_of(window)) {
      const Eigen::Vector3d x = point_on_plane(image.image_from_local, corner, level);
      if (x.allFinite()) shown.push_back(x.head<2>());
    }
  }
  return evaluate::convex_hull(std::move(shown));
}

/// The hull of the judged lines.
HullCorners hull_of_lines(const JudgedFiles& judged) {
  std::vector<Eigen::Vector2d> ends;
  for (const evaluate::Evaluation& evaluation : judged.evaluations) {
    for (const evaluate::LineEvaluation& line : evaluation.lines) {
      if (line.status != evaluate::Status::kEvaluated || !line.segment) continue;
      ends.push_back(line.segment->start.head<2>());
      ends.push_back(line.segment->end.head<2>());
    }
  }
  return evaluate::convex_hull(std::move(ends));
}

double perimeter_m(const HullCorners& corners) {
  double sum_m = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum_m += (corners[(i + 1) % corners.size()] - corners[i]).norm();
  return sum_m;
}

double area_m2_of(const HullCorners& corners) {
  double twice_m2 = 0.0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    twice_m2 += left_of_side(std::vector{corners[0], corners[i]}, 0, corners[i + 1]);
  return 0.5 * twice_m2;
}

/// The places in a convex polygon and up to `by_m` around it.
ScanArea area_around(const HullCorners& corners, double by_m, const char* from) {
  ScanArea area;
  area.scope.area_from = from;
  area.scope.contains = [](const Eigen::Vector2d&) { return false; };
  if (corners.empty()) return area;
  area.box_m = grown(box_around(corners), by_m);
  area.scope.area_m2 =
      area_m2_of(corners) + by_m * perimeter_m(corners) + std::numbers::pi * by_m * by_m;
  area.scope.contains = [corners, by_m](const Eigen::Vector2d& x) {
    if (corners.size() > 2 && is_within(corners, x)) return true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Segment2 side{corners[i], corners[(i + 1) % corners.size()]};
      if (by_m > 0.0 && distance(side, x) <= by_m) return true;
    }
    return false;
  };
  return area;
}

ScanArea stated_area(const Eigen::AlignedBox2d& in_file, const JudgedFiles& judged) {
  const Eigen::Vector2d unit_m = judged.cloud_unit_m.head<2>();
  const Eigen::Vector2d origin_m = judged.frame.origin_m.head<2>();
  const Eigen::AlignedBox2d box(in_file.min().cwiseProduct(unit_m) - origin_m,
                                in_file.max().cwiseProduct(unit_m) - origin_m);
  ScanArea area;
  area.box_m = box;
  area.scope.area_from = "stated";
  area.scope.area_m2 = box.sizes().prod();
  area.scope.contains = [box](const Eigen::Vector2d& x) {
    return (x.array() >= box.min().array()).all() && (x.array() < box.max().array()).all();
  };
  return area;
}

ScanArea plain_area(const JudgedFiles& judged,
                    const JudgeFilesOptions& options,
                    const std::vector<ScopeImage>& images) {
  constexpr double kAroundLines_m = 5.0;
  if (options.area) return stated_area(*options.area, judged);
  if (!options.block_area_m.empty()) {
    const Eigen::Vector2d origin_m = judged.frame.origin_m.head<2>();
    return area_around(
        transformed(options.block_area_m,
                    [&](const Eigen::Vector2d& x) { return Eigen::Vector2d(x - origin_m); }),
        0.0, "block");
  }
  if (!images.empty()) {
    const auto heights_m = io::heights_in_local_m(*options.patch, judged.frame);
    return area_around(shown_ground(images.front(), heights_m), 0.0, "images");
  }
  return area_around(hull_of_lines(judged), kAroundLines_m, "lines");
}

}  // namespace

ScanArea scan_area(const JudgedFiles& judged, const JudgeFilesOptions& options) {
  const std::vector<ScopeImage> images = scope_images(options.patch, judged.frame);
  ScanArea area = plain_area(judged, options, images);
  if (images.empty()) return area;
  area.scope.is_shown = [images](const Segment3& segment) {
    return std::ranges::count_if(images, [&](const ScopeImage& image) {
             return image.shows(segment.start) && image.shows(segment.end);
           }) >= 2;
  };
  return area;
}

}  // namespace ridgeline::results
