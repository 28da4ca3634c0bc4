// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"

#include <Eigen/Core>

namespace ridgeline::simulate {

inline constexpr double kHalfStreetM = 3.5;

/// One street with the lots on both sides, in village coordinates (u along the streets, v across).
/// Its ground is a single plane.
struct TerrainRow {
  double street_v_m = 0.0;  ///< v of the centre line
  PlanFunction ground;      ///< height in local coordinates
  int plane_id = 0;
};

/// Lays out ground, streets and lots as rectangles in village coordinates, clipped to the extent.
class Terrain {
 public:
  /// `azimuth_rad`: angle of the streets to the x axis. The origin of the village coordinates is
  /// the middle of the extent.
  Terrain(double azimuth_rad, SyntheticScene& scene);

  [[nodiscard]] Eigen::Vector2d local(const Eigen::Vector2d& uv) const;

  /// Adds the plane of a row that extends `half_depth_m` to both sides.
  TerrainRow add_row(double street_v_m, double half_depth_m, const PlanFunction& ground);
  void add_tile(const TerrainRow& row,
                const Eigen::Vector2d& low_uv,
                const Eigen::Vector2d& high_uv,
                Material material);
  /// Adds a true line on the ground of the row.
  void add_line(const TerrainRow& row,
                const Eigen::Vector2d& start_uv,
                const Eigen::Vector2d& end_uv,
                LineKind kind = LineKind::kGround);
  /// Adds a dashed centre line and the borders of the street, over [begin, end] along u.
  void add_street(const TerrainRow& row, double begin_u_m, double end_u_m);
  /// Adds two rows of parking bays with their markings.
  void add_parking(const TerrainRow& row,
                   const Eigen::Vector2d& low_uv,
                   const Eigen::Vector2d& high_uv);
  /// Adds the retaining wall between two rows at v.
  void add_retaining_wall(const TerrainRow& low,
                          const TerrainRow& high,
                          double v_m,
                          double half_length_m);

 private:
  void add_stripe(const TerrainRow& row,
                  const Eigen::Vector2d& low_uv,
                  const Eigen::Vector2d& high_uv);

  Eigen::Matrix2d local_from_village_;
  Eigen::Vector2d centre_m_;
  std::vector<PlanFunction> extent_;  // half-planes
  SyntheticScene* scene_;
};

}  // namespace ridgeline::simulate
