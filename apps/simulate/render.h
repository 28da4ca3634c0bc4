// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/appearance.h"
#include "apps/simulate/flight.h"
#include "apps/simulate/ray_scene.h"
#include "reconstruct/geometry/field.h"

#include <opencv2/core/mat.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::simulate {

/// Ratio of sky light to sunlight on level ground.
inline constexpr double kSkyShare = 0.22;

/// Light and rays of a rendered view.
struct RenderOptions {
  double sun_azimuth_deg = 200.0;  ///< clockwise from grid north (+y)
  double sun_elevation_deg = 45.0;
  int samples_per_side = 3;  ///< a pixel has the square of this number of rays
  // Not options; tests change them.
  double backscatter = 0.25;  ///< rough surfaces are brighter by this factor along the sun's rays
  double texture = 1.0;       ///< contrast of the textures; 0: flat colours
  std::uint64_t seed = 1;

  static constexpr auto fields() {
    using O = RenderOptions;
    return std::tuple{
        Field{"sun_azimuth_deg", &O::sun_azimuth_deg, -360.0, 360.0, "clockwise from north"},
        Field{"sun_elevation_deg", &O::sun_elevation_deg, 5.0, 90.0, "above the horizon"},
        Field{"samples_per_side", &O::samples_per_side, 1, 8, "rays per pixel: the square of it"}};
  }
};

/// Unit vector towards the sun, local axes.
Eigen::Vector3d sun_direction(const RenderOptions& options);

/// Renders views of one scene by ray casting: sunlight with cast shadows, sky light, textures fixed
/// to the surfaces.
class Renderer {
 public:
  /// Keeps a reference to the scene. Throws std::invalid_argument for an option outside its range.
  Renderer(const SyntheticScene& scene, const RenderOptions& options);

  /// Noise-free radiance, CV_32FC4 (red, green, blue, near infrared), rows x columns of the view;
  /// 1: white at right angles to the sun. Pixel (0, 0) is the centre of the top-left pixel.
  /// Byte-identical for any number of threads. Pixels beyond AerialView::village_px have one ray.
  [[nodiscard]] cv::Mat radiance(const AerialView& view) const;

  /// Only the rows [first_row, end_row), with the same bytes.
  [[nodiscard]] cv::Mat radiance(const AerialView& view, int first_row, int end_row) const;

 private:
  friend class RowBlock;
  struct SurfacePoint {
    Eigen::Vector3d x;       ///< local
    Eigen::Vector3f normal;  ///< towards the camera
    Spectrum reflectance;
    bool leaf = false;
  };
  [[nodiscard]] std::vector<Spectrum> seen_along(std::span<const RayScene::Ray> rays,
                                                 float footprint_m) const;
  [[nodiscard]] SurfacePoint surface_point(const RayScene::Ray& ray,
                                           const std::optional<RayScene::Hit>& hit,
                                           float footprint_m) const;
  [[nodiscard]] Spectrum sky_light(const SurfacePoint& point) const;
  [[nodiscard]] Spectrum sun_light(const SurfacePoint& point,
                                   const Eigen::Vector3d& direction) const;

  const SyntheticScene* scene_;
  RenderOptions options_;
  RayScene rays_;
  Appearance appearance_;
  Eigen::Vector3d to_sun_;
  double top_z_m_;  ///< above everything in the scene
};

}  // namespace ridgeline::simulate
