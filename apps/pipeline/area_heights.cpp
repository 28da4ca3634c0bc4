// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/area_heights.h"

#include "io/cloud/cloud_files.h"
#include "io/error.h"
#include "io/images/image.h"
#include "reconstruct/geometry/plan_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ridgeline::apps {
namespace {

/// The images of a patch, each with the window to be read, which may be the whole file.
std::vector<io::PatchImage> images_with_windows(const io::PatchFile& patch) {
  std::vector<io::PatchImage> images = patch.images;
  for (io::PatchImage& image : images) {
    const io::ImageFacts facts = io::image_facts(image.path);
    if (!image.window) image.window = io::Window{0, 0, facts.width_px, facts.height_px};
  }
  return images;
}

bool two_show(const std::vector<io::PatchImage>& images, const Eigen::Vector3d& x) {
  return 1 < std::ranges::count_if(images, [&](const io::PatchImage& image) {
           const Eigen::Vector2d px = (image.image_from_world * x.homogeneous()).hnormalized();
           return px.x() >= 0.0 && px.y() >= 0.0 && px.x() < image.window->width &&
                  px.y() < image.window->height;
         });
}

std::vector<double> heights_of_model_m(const io::PatchFile& patch,
                                       std::vector<std::string>& warnings) {
  if (patch.area_m.empty())
    throw io::IoError(patch.path, "height_range: auto with surface_model requires an area");
  const Eigen::AlignedBox2d area_m = box_around(patch.area_m);
  io::SurfaceHeights model = model_heights(patch, area_m);
  if (model.heights_m.empty()) refuse_model(patch, area_m);
  if (auto warning = impossible_heights(patch, model.n_impossible, model.heights_m.size()))
    warnings.push_back(std::move(*warning));
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
  std::size_t first = 0;  // index of the first height of a group without gaps
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

std::array<double, 2> height_range_m(std::span<const double> heights_m) {
  const auto [low, high] = height_limits_m(heights_m);
  return {low - kHeightMargin_m, high + kHeightMargin_m};
}

LidarSample lidar_sample(const io::ProjectFile& project, double margin_m) {
  constexpr std::uint64_t kMaxPoints = 2'000'000;
  io::CloudFiles files(project.lidar, {});
  if (!project.area_m.empty()) {
    const Eigen::AlignedBox2d plan = grown(box_around(project.area_m), margin_m);
    constexpr double kFar_m = 1e5;  // beyond all heights on Earth
    files.set_bounds({Eigen::Vector3d(plan.min().x(), plan.min().y(), -kFar_m),
                      Eigen::Vector3d(plan.max().x(), plan.max().y(), kFar_m)});
  }
  const io::PointCloud cloud = files.read_thinned(std::nullopt, kMaxPoints);
  LidarSample lidar{{}, 0, cloud.crs};
  lidar.points_in_world.reserve(cloud.points.size());
  for (const io::CloudPoint& x : cloud.points)
    lidar.points_in_world.push_back(Eigen::Vector3d(x.x, x.y, x.z) + cloud.frame.origin_m);
  lidar.n_impossible = std::erase_if(lidar.points_in_world, [](const Eigen::Vector3d& x) {
    return !io::is_possible_height(x.z());
  });
  return lidar;
}

void refuse_lidar(const io::ProjectFile& project, const LidarSample& lidar, const char* where) {
  const io::CrsAgreement agreement = io::compare(project.crs, lidar.crs);
  throw io::IoError(project.path,
                    fmt::format("height_range: auto: no LIDAR point lies {}{}{}", where,
                                agreement.compatible ? "" : "; ", agreement.reason));
}

std::optional<std::string> impossible_heights(const io::ProjectFile& project,
                                              std::size_t n_impossible,
                                              std::size_t n_possible) {
  if (n_impossible == 0) return std::nullopt;
  return fmt::format(
      "{}: height_range: auto: {} of {} heights of {} are below -500 m or above 9000 m and are "
      "treated as missing",
      project.path, n_impossible, n_impossible + n_possible,
      project.surface_model ? *project.surface_model : "LIDAR points");
}

io::SurfaceHeights model_heights(const io::ProjectFile& project,
                                 const Eigen::AlignedBox2d& area_m) {
  const double unit_m = io::describe(project.crs).horizontal_unit_m;
  const Eigen::AlignedBox2d bounds(Eigen::Vector2d(area_m.min() / unit_m),
                                   Eigen::Vector2d(area_m.max() / unit_m));
  io::SurfaceHeights model = io::read_surface_heights(*project.surface_model, bounds);
  const io::CrsAgreement agreement = io::compare(project.crs, model.crs);
  if (agreement.compatible) return model;
  throw io::IoError(*project.surface_model,
                    fmt::format("patch and surface model do not match: {}; transform one of them",
                                agreement.reason));
}

void refuse_model(const io::ProjectFile& project, const Eigen::AlignedBox2d& area_m) {
  throw io::IoError(
      *project.surface_model,
      fmt::format("has no heights within x {:.1f} .. {:.1f} m, y {:.1f} .. {:.1f} m",
                  area_m.min().x(), area_m.max().x(), area_m.min().y(), area_m.max().y()));
}

std::vector<double> area_heights_m(const io::PatchFile& patch, std::vector<std::string>& warnings) {
  if (patch.surface_model) return heights_of_model_m(patch, warnings);
  const LidarSample lidar = lidar_sample(patch);
  if (auto warning = impossible_heights(patch, lidar.n_impossible, lidar.points_in_world.size()))
    warnings.push_back(std::move(*warning));
  const bool has_area = !patch.area_m.empty();
  const std::vector<io::PatchImage> images =
      has_area ? std::vector<io::PatchImage>() : images_with_windows(patch);
  std::vector<double> heights_m;
  for (const Eigen::Vector3d& x : lidar.points_in_world) {
    if (has_area ? is_within(patch.area_m, x.head<2>()) : two_show(images, x))
      heights_m.push_back(x.z());
  }
  if (heights_m.empty())
    refuse_lidar(patch, lidar, has_area ? "in the area" : "where two images show it");
  return heights_m;
}

}  // namespace ridgeline::apps
