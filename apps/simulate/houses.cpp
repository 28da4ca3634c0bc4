// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/houses.h"

#include <Eigen/Geometry>

#include <cmath>

namespace ridgeline::simulate {
namespace {

/// Plan rectangle centred at (u, v).
ConvexPolygon centred(double u, double v, double half_u, double half_v) {
  return rectangle({u - half_u, v - half_v}, {u + half_u, v + half_v});
}

RoofPart box(const HouseShape& shape, double overhang_u, double overhang_v) {
  const double half_u = 0.5 * shape.length_m;
  const double half_v = 0.5 * shape.width_m;
  RoofPart part;
  part.outline = centred(0.0, 0.0, half_u + overhang_u, half_v + overhang_v);
  part.walls = centred(0.0, 0.0, half_u, half_v);
  constexpr double kFoundationM = 1.0;  // closes gaps on sloping ground
  part.base_z_m = shape.floor_z_m - kFoundationM;
  part.slab_thickness_m = shape.slab_thickness_m;
  part.building_id = shape.building_id;
  return part;
}

double wall_top_z(const HouseShape& shape) { return shape.floor_z_m + shape.wall_height_m; }

/// Two planes that slope down on both sides of a ridge at height `ridge_z` through `origin`;
/// `across` is perpendicular to the ridge.
std::vector<PlanFunction> gable_planes(const Eigen::Vector2d& origin,
                                       const Eigen::Vector2d& across,
                                       double ridge_z,
                                       double slope) {
  std::vector<PlanFunction> planes;
  for (const double side : {1.0, -1.0}) {
    const Eigen::Vector2d gradient = -side * slope * across;
    planes.push_back({gradient, ridge_z - gradient.dot(origin)});
  }
  return planes;
}

RoofPart flat_part(const HouseShape& shape, const ConvexPolygon& outline, double z) {
  RoofPart part = box(shape, 0.0, 0.0);
  part.outline = outline;
  part.walls = outline;
  part.slab_thickness_m = 0.0;
  part.tops = {PlanFunction{Eigen::Vector2d::Zero(), z}};
  return part;
}

}  // namespace

double ridge_z_m(const HouseShape& shape) {
  return wall_top_z(shape) + std::tan(shape.pitch_rad) * 0.5 * shape.width_m;
}

std::vector<RoofPart> gabled(const HouseShape& shape) {
  RoofPart part = box(shape, shape.verge_overhang_m, shape.eave_overhang_m);
  part.tops = gable_planes(Eigen::Vector2d::Zero(), Eigen::Vector2d::UnitY(), ridge_z_m(shape),
                           std::tan(shape.pitch_rad));
  return {part};
}

std::vector<RoofPart> hipped(const HouseShape& shape) {
  RoofPart part = box(shape, shape.eave_overhang_m, shape.eave_overhang_m);
  const double slope = std::tan(shape.pitch_rad);
  part.tops =
      gable_planes(Eigen::Vector2d::Zero(), Eigen::Vector2d::UnitY(), ridge_z_m(shape), slope);
  for (const double side : {1.0, -1.0}) {
    part.tops.push_back(
        {Eigen::Vector2d(-side * slope, 0.0), wall_top_z(shape) + slope * 0.5 * shape.length_m});
  }
  return {part};
}

std::vector<RoofPart> flat(const HouseShape& shape) {
  RoofPart part = box(shape, shape.eave_overhang_m, shape.eave_overhang_m);
  part.tops = {PlanFunction{Eigen::Vector2d::Zero(), wall_top_z(shape)}};
  return {part};
}

std::vector<RoofPart> parapet(const HouseShape& shape, double rim_width_m, double rim_height_m) {
  const double u = 0.5 * shape.length_m;
  const double v = 0.5 * shape.width_m;
  const ConvexPolygon outer = centred(0.0, 0.0, u, v);
  const ConvexPolygon inner = centred(0.0, 0.0, u - rim_width_m, v - rim_width_m);
  RoofPart deck = flat_part(shape, inner, wall_top_z(shape));
  deck.is_joint.assign(4, true);
  std::vector<RoofPart> parts{deck};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    // four pieces with mitred ends, because a ring is not convex
    RoofPart rim = flat_part(shape, {outer[i], outer[j], inner[j], inner[i]},
                             wall_top_z(shape) + rim_height_m);
    rim.is_joint = {false, true, false, true};
    parts.push_back(rim);
  }
  return parts;
}

std::vector<RoofPart> shed(const HouseShape& shape) {
  RoofPart part = box(shape, shape.verge_overhang_m, shape.eave_overhang_m);
  const double slope = std::tan(shape.pitch_rad);
  part.tops = {
      PlanFunction{Eigen::Vector2d(0.0, slope), wall_top_z(shape) + slope * 0.5 * shape.width_m}};
  return {part};
}

std::vector<RoofPart> l_shaped(const HouseShape& shape, const Wing& wing) {
  std::vector<RoofPart> parts = gabled(shape);
  const double slope = std::tan(shape.pitch_rad);
  const double half = 0.5 * wing.width_m;
  const double end_v = 0.5 * shape.width_m + wing.length_m;
  RoofPart part = box(shape, 0.0, 0.0);
  part.walls = rectangle({wing.centre_u_m - half, 0.0}, {wing.centre_u_m + half, end_v});
  part.outline =
      rectangle({wing.centre_u_m - half - shape.eave_overhang_m, 0.0},
                {wing.centre_u_m + half + shape.eave_overhang_m, end_v + shape.verge_overhang_m});
  part.tops = gable_planes({wing.centre_u_m, 0.0}, Eigen::Vector2d::UnitX(),
                           wall_top_z(shape) + slope * half, slope);
  parts.push_back(part);
  return parts;
}

RoofPart dormer(const HouseShape& shape, const Dormer& dormer) {
  constexpr double kOverhangM = 0.15;
  constexpr double kInnerEndM = 0.1;  // extent beyond the line where it meets the main roof
  const double front_v = 0.5 * shape.width_m - dormer.setback_m;
  const double main_z = ridge_z_m(shape) - std::tan(shape.pitch_rad) * front_v;
  const double eave_z = main_z + dormer.front_height_m;
  const double half = 0.5 * dormer.width_m;
  const double slope = std::tan(dormer.pitch_rad);
  const double u = dormer.centre_u_m;

  RoofPart part = box(shape, 0.0, 0.0);
  part.base_z_m = main_z - shape.slab_thickness_m;
  part.slab_thickness_m = 0.12;
  part.walls = rectangle({u - half, kInnerEndM}, {u + half, front_v});
  part.outline =
      rectangle({u - half - kOverhangM, kInnerEndM}, {u + half + kOverhangM, front_v + kOverhangM});
  if (dormer.type == DormerType::kGabled) {
    part.tops = gable_planes({u, 0.0}, Eigen::Vector2d::UnitX(), eave_z + slope * half, slope);
  } else {
    part.tops = {PlanFunction{Eigen::Vector2d(0.0, -slope), eave_z + slope * front_v}};
  }
  return part;
}

RoofPart chimney(const HouseShape& shape, double u_m, double v_m, double above_ridge_m) {
  constexpr double kHalfLengthM = 0.4;
  constexpr double kHalfWidthM = 0.25;
  RoofPart part = flat_part(shape, centred(u_m, v_m, kHalfLengthM, kHalfWidthM),
                            ridge_z_m(shape) + above_ridge_m);
  part.base_z_m = wall_top_z(shape);
  part.kind = PlaneKind::kChimney;
  return part;
}

RoofPart placed(const RoofPart& part, const Eigen::Vector2d& position_m, double azimuth_rad) {
  const Eigen::Matrix2d plan_from_house = Eigen::Rotation2Dd(azimuth_rad).toRotationMatrix();
  RoofPart result = part;
  for (ConvexPolygon* polygon : {&result.outline, &result.walls}) {
    for (Eigen::Vector2d& x : *polygon) x = plan_from_house * x + position_m;
  }
  for (PlanFunction& top : result.tops) {
    top.gradient = plan_from_house * top.gradient;
    top.offset -= top.gradient.dot(position_m);
  }
  return result;
}

}  // namespace ridgeline::simulate
