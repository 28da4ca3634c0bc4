// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/scene.h"
#include "io/cloud/point_cloud.h"

#include <Eigen/Core>

#include <vector>

namespace ridgeline::test {

/// One house in the middle of 40 m x 40 m of level ground at z = 0: walls 12 m x 8 m, 5 m high,
/// eave overhang 0.5 m, verge overhang 0.3 m (hips: 0.5 m all round). Plane 0 is the ground. At
/// azimuth 0 the ridge is parallel to x.
struct HouseScene {
  static constexpr double kLengthM = 12.0;
  static constexpr double kWidthM = 8.0;
  static constexpr double kWallHeightM = 5.0;
  static constexpr double kEaveOverhangM = 0.5;
  static constexpr double kVergeOverhangM = 0.3;
};
simulate::SyntheticScene gabled_house(double pitch_deg, double azimuth_deg = 0.0);
simulate::SyntheticScene hipped_house(double pitch_deg, double azimuth_deg = 0.0);
simulate::SyntheticScene flat_house(double azimuth_deg = 0.0);

/// A point of the top surface and the plane on which it lies.
struct SurfaceSample {
  Eigen::Vector3d x;  ///< local
  int plane_id;
};

/// Finds the top surface of a scene from its planes, without ray casting.
class TopSurface {
 public:
  explicit TopSurface(const simulate::SyntheticScene& scene);
  /// The uppermost plane over a plan position; plane_id is kNone outside all planes.
  [[nodiscard]] SurfaceSample at(const Eigen::Vector2d& x) const;

 private:
  struct Face {
    int plane_id;
    Plane3 plane;
    std::vector<simulate::PlanFunction> sides;
  };
  std::vector<Face> faces_;
};

/// Noise-free points of the top surface on a square grid over the extent.
std::vector<SurfaceSample> sample_grid(const simulate::SyntheticScene& scene, double spacing_m);

/// Samples as a cloud in the frame of the scene: class 2 on the ground, 6 on roofs, one return
/// each.
io::PointCloud cloud_of(const simulate::SyntheticScene& scene,
                        const std::vector<SurfaceSample>& samples);

}  // namespace ridgeline::test
