// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/terrain.h"

#include "apps/simulate/mesh_builder.h"

#include <Eigen/Geometry>

namespace ridgeline::simulate {
namespace {

constexpr double kStripeM = 0.12;  // width of a marking

Eigen::Vector3d on(const PlanFunction& height, const Eigen::Vector2d& x) {
  return {x.x(), x.y(), height(x)};
}

}  // namespace

Terrain::Terrain(double azimuth_rad, SyntheticScene& scene)
    : local_from_village_(Eigen::Rotation2Dd(azimuth_rad).toRotationMatrix()),
      centre_m_(0.5 * scene.extent_m),
      extent_(half_planes(rectangle(Eigen::Vector2d::Zero(), scene.extent_m))),
      scene_(&scene) {}

Eigen::Vector2d Terrain::local(const Eigen::Vector2d& uv) const {
  return local_from_village_ * uv + centre_m_;
}

TerrainRow Terrain::add_row(double street_v_m, double half_depth_m, const PlanFunction& ground) {
  const double half_length_m = scene_->extent_m.norm();
  ConvexPolygon outline = rectangle({-half_length_m, street_v_m - half_depth_m},
                                    {half_length_m, street_v_m + half_depth_m});
  for (Eigen::Vector2d& x : outline) x = local(x);
  TerrainRow row{street_v_m, ground, static_cast<int>(scene_->planes.size())};
  ScenePlane plane{.id = row.plane_id,
                   .plane = plane_of(ground),
                   .outline = {},
                   .building_id = kNone,
                   .kind = PlaneKind::kGround};
  for (const Eigen::Vector2d& x : clip(outline, extent_)) plane.outline.push_back(on(ground, x));
  scene_->planes.push_back(std::move(plane));
  return row;
}

void Terrain::add_tile(const TerrainRow& row,
                       const Eigen::Vector2d& low_uv,
                       const Eigen::Vector2d& high_uv,
                       Material material) {
  ConvexPolygon tile = rectangle(low_uv, high_uv);
  for (Eigen::Vector2d& x : tile) x = local(x);
  std::vector<Eigen::Vector3d> corners;
  for (const Eigen::Vector2d& x : clip(tile, extent_)) corners.push_back(on(row.ground, x));
  // each garden has its own lawn; a street is one surface
  const int object = material == Material::kGround ? next_object_id(scene_->mesh) : kNone;
  add_polygon(corners, {kNone, row.plane_id, material, object}, scene_->mesh);
}

void Terrain::add_line(const TerrainRow& row,
                       const Eigen::Vector2d& start_uv,
                       const Eigen::Vector2d& end_uv,
                       LineKind kind) {
  constexpr double kMinLengthM = 0.5;
  const Segment2 segment{local(start_uv), local(end_uv)};
  PlanInterval interval;
  for (const PlanFunction& side : extent_) interval = clip(interval, segment, side);
  if ((interval.end - interval.begin) * length(segment) < kMinLengthM) return;
  const auto at = [&](double t) -> Eigen::Vector3d {
    return on(row.ground, (1.0 - t) * segment.start + t * segment.end);
  };
  scene_->lines.push_back({.segment = {at(interval.begin), at(interval.end)},
                           .kind = kind,
                           .plane_ids = {row.plane_id},
                           .building_id = kNone});
}

void Terrain::add_stripe(const TerrainRow& row,
                         const Eigen::Vector2d& low_uv,
                         const Eigen::Vector2d& high_uv) {
  add_tile(row, low_uv, high_uv, Material::kMarking);
  const bool along_u = high_uv.x() - low_uv.x() > high_uv.y() - low_uv.y();
  const Eigen::Vector2d third =
      along_u ? Eigen::Vector2d(low_uv.x(), high_uv.y()) : Eigen::Vector2d(high_uv.x(), low_uv.y());
  const Eigen::Vector2d fourth = low_uv + high_uv - third;
  add_line(row, low_uv, fourth);
  add_line(row, third, high_uv);
}

void Terrain::add_street(const TerrainRow& row, double begin_u_m, double end_u_m) {
  constexpr double kDashM = 3.0;
  constexpr double kGapM = 6.0;
  constexpr double kHalfStripeM = 0.5 * kStripeM;
  const double v = row.street_v_m;
  for (const double side : {-1.0, 1.0}) {
    const double border = v + side * kHalfStreetM;
    const double stripe = v + side * kHalfStripeM;
    add_tile(row, {begin_u_m, std::min(border, stripe)}, {end_u_m, std::max(border, stripe)},
             Material::kStreet);
    add_line(row, {begin_u_m, border}, {end_u_m, border});
  }
  double u = begin_u_m;
  while (u < end_u_m) {
    const double dash_end = std::min(u + kDashM, end_u_m);
    const double gap_end = std::min(u + kDashM + kGapM, end_u_m);
    add_stripe(row, {u, v - kHalfStripeM}, {dash_end, v + kHalfStripeM});
    add_tile(row, {dash_end, v - kHalfStripeM}, {gap_end, v + kHalfStripeM}, Material::kStreet);
    u = gap_end;
  }
}

void Terrain::add_parking(const TerrainRow& row,
                          const Eigen::Vector2d& low_uv,
                          const Eigen::Vector2d& high_uv) {
  constexpr double kBayM = 2.5;
  constexpr double kBayDepthM = 5.0;
  const double middle_low = low_uv.y() + kBayDepthM;
  const double middle_high = high_uv.y() - kBayDepthM;
  add_tile(row, {low_uv.x(), middle_low}, {high_uv.x(), middle_high}, Material::kStreet);
  for (const double v : {low_uv.y(), middle_high}) {
    double u = low_uv.x();
    while (u < high_uv.x()) {
      const double stripe_end = std::min(u + kStripeM, high_uv.x());
      const double bay_end = std::min(u + kBayM, high_uv.x());
      add_stripe(row, {u, v}, {stripe_end, v + kBayDepthM});
      add_tile(row, {stripe_end, v}, {bay_end, v + kBayDepthM}, Material::kStreet);
      u = bay_end;
    }
  }
}

void Terrain::add_retaining_wall(const TerrainRow& low,
                                 const TerrainRow& high,
                                 double v_m,
                                 double half_length_m) {
  const Segment2 segment{local({-half_length_m, v_m}), local({half_length_m, v_m})};
  PlanInterval interval;
  for (const PlanFunction& side : extent_) interval = clip(interval, segment, side);
  if (interval.empty()) return;
  const Eigen::Vector2d a = segment.start + interval.begin * (segment.end - segment.start);
  const Eigen::Vector2d b = segment.start + interval.end * (segment.end - segment.start);
  add_polygon({on(low.ground, a), on(low.ground, b), on(high.ground, b), on(high.ground, a)},
              {kNone, kNone, Material::kWall}, scene_->mesh);
}

}  // namespace ridgeline::simulate
