// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/area_heights.h"

#include "io/cloud/cloud_files.h"
#include "io/error.h"
#include "io/gdal/surface_heights.h"
#include "io/images/image.h"
#include "reconstruct/geometry/plan_box.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace ridgeline::apps {
namespace {

using Points = std::vector<Eigen::Vector3d>;

struct Lidar {
  Points points_in_world;
  io::Crs crs;
};

/// The LIDAR of a patch, within the box around its area; thinned where there are very many points.
Lidar lidar_of(const io::PatchFile& patch) {
  constexpr std::uint64_t kMaxPoints = 2'000'000;
  io::CloudFiles files(patch.lidar, {});
  if (!patch.area_m.empty()) {
    const Eigen::AlignedBox2d plan = box_around(patch.area_m);
    constexpr double kFar_m = 1e5;  // beyond all heights on Earth
    files.set_bounds({Eigen::Vector3d(plan.min().x(), plan.min().y(), -kFar_m),
                      Eigen::Vector3d(plan.max().x(), plan.max().y(), kFar_m)});
  }
  const io::PointCloud cloud = files.read_thinned(std::nullopt, kMaxPoints);
  Lidar lidar{{}, cloud.crs};
  lidar.points_in_world.reserve(cloud.points.size());
  for (const io::CloudPoint& x : cloud.points)
    lidar.points_in_world.push_back(Eigen::Vector3d(x.x, x.y, x.z) + cloud.frame.origin_m);
  return lidar;
}

/// An image of the patch as far as it matters what it shows.
struct PlacedFrame {
  ProjectionMatrix image_from_world;
  Eigen::Vector2d size_px;
};

std::vector<PlacedFrame> frames_of(const io::PatchFile& patch) {
  std::vector<PlacedFrame> frames;
  for (const io::PatchImage& image : patch.images) {
    const io::ImageFacts facts = io::image_facts(image.path);
    frames.push_back({image.image_from_world,
                      image.window ? Eigen::Vector2d(image.window->width, image.window->height)
                                   : Eigen::Vector2d(facts.width_px, facts.height_px)});
  }
  return frames;
}

bool two_show(const std::vector<PlacedFrame>& frames, const Eigen::Vector3d& x) {
  return 1 < std::ranges::count_if(frames, [&](const PlacedFrame& frame) {
           const Eigen::Vector2d px = (frame.image_from_world * x.homogeneous()).hnormalized();
           return px.x() >= 0.0 && px.y() >= 0.0 && px.x() < frame.size_px.x() &&
                  px.y() < frame.size_px.y();
         });
}

std::vector<double> heights_of(const io::PatchFile& patch, const Points& points) {
  const std::vector<PlacedFrame> frames =
      patch.area_m.empty() ? frames_of(patch) : std::vector<PlacedFrame>();
  std::vector<double> heights;
  for (const Eigen::Vector3d& x : points) {
    const bool counts =
        patch.area_m.empty() ? two_show(frames, x) : is_within(patch.area_m, x.head<2>());
    if (counts) heights.push_back(x.z());
  }
  return heights;
}

std::vector<double> heights_of_lidar(const io::PatchFile& patch) {
  const Lidar lidar = lidar_of(patch);
  std::vector<double> heights = heights_of(patch, lidar.points_in_world);
  if (!heights.empty()) return heights;
  const io::CrsAgreement agreement = io::compare(patch.crs, lidar.crs);
  throw io::IoError(patch.path,
                    fmt::format("height_range: auto: no LIDAR point lies {}{}{}",
                                patch.area_m.empty() ? "where two images show it" : "in the area",
                                agreement.compatible ? "" : "; ", agreement.reason));
}

std::vector<double> heights_of_model(const io::PatchFile& patch) {
  if (patch.area_m.empty()) {
    throw io::IoError(patch.path, "height_range: auto with surface_model requires an area");
  }
  const double unit_m = io::describe(patch.crs).horizontal_unit_m;
  Eigen::AlignedBox2d bounds = box_around(patch.area_m);
  bounds = {Eigen::Vector2d(bounds.min() / unit_m), Eigen::Vector2d(bounds.max() / unit_m)};
  io::SurfaceHeights model = io::read_surface_heights(*patch.surface_model, bounds);
  const io::CrsAgreement agreement = io::compare(patch.crs, model.crs);
  if (!agreement.compatible) {
    throw io::IoError(*patch.surface_model,
                      fmt::format("patch and surface model do not match: {}; transform one of them",
                                  agreement.reason));
  }
  return std::move(model.heights_m);
}

}  // namespace

std::array<double, 2> height_limits_m(std::span<const double> heights_m) {
  constexpr double kMinShare = 1e-3;
  std::vector<double> sorted(heights_m.begin(), heights_m.end());
  std::ranges::sort(sorted);
  const double least = kMinShare * static_cast<double>(sorted.size());
  double low = sorted.back();
  double high = sorted.front();
  std::size_t first = 0;  // of a group without a gap
  for (std::size_t i = 1; i <= sorted.size(); ++i) {
    if (i < sorted.size() && sorted[i] - sorted[i - 1] <= kHeightMargin_m) continue;
    if (static_cast<double>(i - first) >= least) {
      low = std::min(low, sorted[first]);
      high = std::max(high, sorted[i - 1]);
    }
    first = i;
  }
  return {low, high};
}

AreaHeights area_heights(const io::PatchFile& patch) {
  const std::vector<double> heights =
      patch.heights == io::HeightSource::kLidar ? heights_of_lidar(patch) : heights_of_model(patch);
  const auto [low, high] = height_limits_m(heights);
  return {{low - kHeightMargin_m, high + kHeightMargin_m}, heights.size()};
}

}  // namespace ridgeline::apps
