// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/area_views.h"

#include "io/images/image.h"
#include "reconstruct/geometry/transformed.h"
#include "reconstruct/scene/choose_views.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace ridgeline::apps {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// The centre of the area at the middle of the height range.
Eigen::Vector3d middle_of(const SearchedPlace& place) {
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& x : place.area_m)
    middle += x / static_cast<double>(place.area_m.size());
  return {middle.x(), middle.y(), 0.5 * (place.height_range_m[0] + place.height_range_m[1])};
}

/// The corners of an area and points between them: `per_side` per side, including its first corner.
std::vector<Eigen::Vector2d> border_of(const std::vector<Eigen::Vector2d>& corners, int per_side) {
  std::vector<Eigen::Vector2d> border;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d side = corners[(i + 1) % corners.size()] - corners[i];
    for (int k = 0; k < per_side; ++k)
      border.emplace_back(corners[i] + static_cast<double>(k) / per_side * side);
  }
  return border;
}

/// Points spread over the area at the middle of the height range, relative to middle_of(): its
/// centre and points on three rings with the shape of its border.
Points points_in_local(const SearchedPlace& place) {
  constexpr int kRings = 3;
  constexpr int kPerSide = 4;
  Points points{Eigen::Vector3d::Zero()};
  const Eigen::Vector2d middle = middle_of(place).head<2>();
  const std::vector<Eigen::Vector2d> border = border_of(
      transformed(place.area_m,
                  [&](const Eigen::Vector2d& x) -> Eigen::Vector2d { return x - middle; }),
      kPerSide);
  for (int ring = 1; ring <= kRings; ++ring) {
    for (const Eigen::Vector2d& outer : border) {
      const Eigen::Vector2d x = static_cast<double>(ring) / kRings * outer;
      points.emplace_back(x.x(), x.y(), 0.0);
    }
  }
  return points;
}

Eigen::Vector2i size_of(const io::PatchImage& image) {
  if (image.interior && image.interior->size_px) return *image.interior->size_px;
  const io::ImageFacts facts = io::image_facts(image.path);
  return {facts.width_px, facts.height_px};
}

reconstruct::CandidateView candidate_of(const io::PatchImage& image,
                                        const Eigen::Vector3d& origin_m) {
  return {image.id, image_from_local(image.image_from_world, origin_m), size_of(image)};
}

/// The image position of a point, with lens distortion, in pixels of the part read; std::nullopt
/// behind the camera.
std::optional<Eigen::Vector2d> shown_at(const io::PatchImage& image,
                                        const ProjectionMatrix& image_from_local,
                                        const Eigen::Vector3d& x,
                                        const Eigen::Vector2i& size_px) {
  const Eigen::Vector3d y = image_from_local * x.homogeneous();
  const double side = image_from_local.leftCols<3>().determinant() > 0.0 ? 1.0 : -1.0;
  if (!(side * y.z() > 0.0)) return std::nullopt;
  // Far outside the frame the distortion model is invalid and may fold back into the frame.
  const Eigen::Vector2d reach = 0.25 * size_px.cast<double>();
  const Eigen::Vector2d ideal =
      y.hnormalized().cwiseMax(-reach).cwiseMin(size_px.cast<double>() + reach);
  if (!image.interior || image.interior->distortion.is_zero()) return ideal;
  return distorted_px(*image.interior, ideal + image.window_px) - image.window_px;
}

}  // namespace

std::vector<io::PatchImage> best_images(const std::vector<io::PatchImage>& images,
                                        std::size_t max_views,
                                        const SearchedPlace& place) {
  const Eigen::Vector3d origin_m = middle_of(place);
  const auto candidates = transformed(
      images, [&](const io::PatchImage& image) { return candidate_of(image, origin_m); });
  std::vector<io::PatchImage> best;
  for (const std::size_t i :
       reconstruct::choose_views(candidates, points_in_local(place),
                                 place.height_range_m[1] - place.height_range_m[0], max_views))
    best.push_back(images[i]);
  return best;
}

std::vector<io::PatchImage> images_that_show(const SearchedPlace& place,
                                             const std::vector<io::PatchImage>& images) {
  constexpr double kMinShare = 0.1;
  const Eigen::Vector3d origin_m = middle_of(place);
  const Points points = points_in_local(place);
  std::vector<io::PatchImage> found;
  for (const io::PatchImage& image : images) {
    if (!image.interior || !image.interior->size_px) continue;
    if (reconstruct::seen_share(candidate_of(image, origin_m), points) >= kMinShare)
      found.push_back(image);
  }
  return found;
}

std::optional<io::Window> window_of_area(const SearchedPlace& place,
                                         const io::PatchImage& image,
                                         const Eigen::Vector2i& size_px) {
  constexpr double kMargin_px = 32.0;
  constexpr int kPerSide = 8;  // because the lens bends the sides
  const Eigen::Vector3d origin_m = middle_of(place);
  const ProjectionMatrix P = image_from_local(image.image_from_world, origin_m);
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : border_of(place.area_m, kPerSide)) {
    for (const double z : place.height_range_m) {
      const Eigen::Vector3d x = Eigen::Vector3d(corner.x(), corner.y(), z) - origin_m;
      const std::optional<Eigen::Vector2d> at = shown_at(image, P, x, size_px);
      // If part of the area lies behind an oblique camera, its extent in the image is unbounded.
      if (!at) return io::Window{0, 0, size_px.x(), size_px.y()};
      box.extend(*at);
    }
  }
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(kMargin_px);
  const Eigen::Vector2d zero = Eigen::Vector2d::Zero();
  const Eigen::Vector2d first = (box.min() - margin).array().floor().matrix().cwiseMax(zero);
  const Eigen::Vector2d end =
      (box.max() + margin).array().ceil().matrix().cwiseMin(size_px.cast<double>());
  const Eigen::Vector2i size = (end - first).cast<int>();
  if ((size.array() < 2).any()) return std::nullopt;
  return io::Window{static_cast<int>(first.x()), static_cast<int>(first.y()), size.x(), size.y()};
}

}  // namespace ridgeline::apps
