// SPDX-License-Identifier: BSD-3-Clause
#include "io/orientation/footprints.h"

#include "io/error.h"
#include "io/gdal/geopackage_writer.h"
#include "io/orientation/conventions.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ridgeline::io {
namespace {

using Ring = std::vector<Eigen::Vector3d>;

/// If the cosine of its angle to the plumb line is smaller than this, a ray is treated as missing
/// the ground: it would reach it six flying heights away.
constexpr double kSteepEnough = 0.17;

std::optional<Eigen::Vector3d> on_ground(const InteriorOrientation& interior,
                                         const ExteriorOrientation& exterior,
                                         const Eigen::Vector2d& x_px,
                                         double height_m) {
  const std::optional<Eigen::Vector2d> ideal = undistorted_px(interior, x_px);
  if (!ideal) return std::nullopt;
  const Eigen::Vector2d v =
      (*ideal - interior.principal_point_px).cwiseQuotient(interior.focal_length_px);
  const Eigen::Vector3d ray =
      (exterior.world_from_camera_axes * Eigen::Vector3d(v.x(), -v.y(), -1.0)).normalized();
  const double depth_m = exterior.position_m.z() - height_m;
  if (!(depth_m > 0.0) || ray.z() > -kSteepEnough) return std::nullopt;
  return exterior.position_m - ray * (depth_m / ray.z());
}

/// Whether a point lies within a ring, determined by the number of sides to its right.
bool is_within(const Ring& ring, const Eigen::Vector2d& x) {
  bool within = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Eigen::Vector3d& a = ring[i];
    const Eigen::Vector3d& b = ring[j];
    if ((a.y() > x.y()) == (b.y() > x.y())) continue;
    if (x.x() < a.x() + (x.y() - a.y()) * (b.x() - a.x()) / (b.y() - a.y())) within = !within;
  }
  return within;
}

MapLayer camera_layer(const Orientation& orientation) {
  MapLayer layer{.name = "cameras",
                 .description = "where the images were taken",
                 .geometry = MapGeometry::kPoint,
                 .columns = {{"image", ColumnType::kText},
                             {"camera", ColumnType::kText},
                             {"omega_deg", ColumnType::kReal},
                             {"phi_deg", ColumnType::kReal},
                             {"kappa_deg", ColumnType::kReal}},
                 .features = {},
                 .style = {}};
  for (const OrientedImage& image : orientation.images) {
    const Angles angles = angles_deg(image.exterior.world_from_camera_axes);
    SparseRow row{{0, image.name}, {2, angles.omega}, {3, angles.phi}, {4, angles.kappa}};
    if (image.camera) row.emplace_back(1, orientation.cameras[*image.camera].name);
    layer.features.push_back({{image.exterior.position_m}, row});
  }
  return layer;
}

struct Footprints {
  std::vector<Ring> rings;
  MapLayer layer;
};

Footprints footprints_of(const Orientation& orientation, double height_m) {
  Footprints all{
      {},
      {.name = "footprints",
       .description = fmt::format("what the images show at a height of {:.1f} m", height_m),
       .geometry = MapGeometry::kPolygon,
       .columns = {{"image", ColumnType::kText}},
       .features = {},
       .style = {}}};
  for (const OrientedImage& image : orientation.images) {
    const std::optional<Ring> ring = footprint(orientation, image, height_m);
    if (!ring) continue;
    all.rings.push_back(*ring);
    all.layer.features.push_back({*ring, {{0, image.name}}});
  }
  return all;
}

Eigen::AlignedBox2d extent_of_rings(const std::vector<Ring>& rings) {
  Eigen::AlignedBox2d extent;
  for (const Ring& ring : rings) {
    for (const Eigen::Vector3d& x : ring) extent.extend(Eigen::Vector2d(x.head<2>()));
  }
  return extent;
}

MapFeature cell_of(const Eigen::Vector2d& corner,
                   double side_m,
                   double height_m,
                   std::int64_t count) {
  Ring ring;
  for (const auto& [dx, dy] : {std::array{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
    ring.emplace_back(corner.x() + dx * side_m, corner.y() + dy * side_m, height_m);
  }
  return {ring, {{0, count}}};
}

/// Square cells with the number of images that see their centres; cells not seen by any image are
/// left out.
MapLayer overlap_layer(const std::vector<Ring>& rings, double height_m) {
  constexpr double kCells = 2500.0;
  constexpr double kMaxCellsPerRow = 500.0;  // for long strips
  MapLayer layer{.name = "overlap",
                 .description = "number of images that show the centre of a cell",
                 .geometry = MapGeometry::kPolygon,
                 .columns = {{"n_images", ColumnType::kInteger}},
                 .features = {},
                 .style = {}};
  const Eigen::AlignedBox2d extent = extent_of_rings(rings);
  const double side_m = std::max(std::sqrt(extent.sizes().prod() / kCells),
                                 extent.sizes().maxCoeff() / kMaxCellsPerRow);
  const Eigen::Vector2i n = (extent.sizes() / side_m).array().ceil().cast<int>();
  for (int row = 0; row < n.y(); ++row) {
    for (int column = 0; column < n.x(); ++column) {
      const Eigen::Vector2d corner = extent.min() + side_m * Eigen::Vector2d(column, row);
      const Eigen::Vector2d middle = corner.array() + 0.5 * side_m;
      const auto count =
          std::ranges::count_if(rings, [&](const Ring& ring) { return is_within(ring, middle); });
      if (count > 0) layer.features.push_back(cell_of(corner, side_m, height_m, count));
    }
  }
  return layer;
}

}  // namespace

std::optional<std::vector<Eigen::Vector3d>> footprint(const Orientation& orientation,
                                                      const OrientedImage& image,
                                                      double height_m) {
  if (!image.camera) return std::nullopt;
  const InteriorOrientation& interior = orientation.cameras[*image.camera].interior;
  if (!interior.size_px) return std::nullopt;
  const Eigen::Vector2d far_px = interior.size_px->cast<double>() - Eigen::Vector2d::Constant(0.5);
  const double near_px = -0.5;
  const Eigen::Vector2d middle_px = 0.5 * (far_px + Eigen::Vector2d::Constant(near_px));
  const std::array<Eigen::Vector2d, 8> border{{{near_px, near_px},
                                               {middle_px.x(), near_px},
                                               {far_px.x(), near_px},
                                               {far_px.x(), middle_px.y()},
                                               far_px,
                                               {middle_px.x(), far_px.y()},
                                               {near_px, far_px.y()},
                                               {near_px, middle_px.y()}}};
  Ring ring;
  for (const Eigen::Vector2d& x_px : border) {
    const auto x = on_ground(interior, image.exterior, x_px, height_m);
    if (!x) return std::nullopt;
    ring.push_back(*x);
  }
  return ring;
}

void write_orientation_map(const std::string& path,
                           const Orientation& orientation,
                           double ground_height_m) {
  Footprints all = footprints_of(orientation, ground_height_m);
  if (all.rings.empty()) {
    throw IoError(path, fmt::format("has no footprint: no camera looks at the ground at {:.1f} m",
                                    ground_height_m));
  }
  const std::vector<MapLayer> layers{overlap_layer(all.rings, ground_height_m), all.layer,
                                     camera_layer(orientation)};
  write_geopackage(path, orientation.crs, layers);
}

}  // namespace ridgeline::io
