// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/render.h"

#include "apps/simulate/noise.h"
#include "apps/simulate/point_spread.h"
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/degrees.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ridgeline::simulate {
namespace {

constexpr double kShadowOffsetM = 2e-3;   // offset of shadow rays; Embree's float is good to 0.1 mm
constexpr double kLeafClearanceM = 0.05;  // a leaf does not shadow itself

constexpr double kPointSpreadSigma_px = 0.55;  // Gaussian, for lens and detector together

double top_z_m(const Mesh& mesh) {
  double top = 0.0;
  for (const Eigen::Vector3d& x : mesh.vertices) top = std::max(top, x.z());
  return top + 1.0;
}

/// Colours of direct sunlight and of a clear sky.
Spectrum sun_colour() { return {1.00F, 0.96F, 0.88F, 1.00F}; }
Spectrum sky_colour() { return {0.75F, 1.00F, 1.40F, 0.40F}; }

}  // namespace

Eigen::Vector3d sun_direction(const RenderOptions& options) {
  const double azimuth = kRadPerDeg * options.sun_azimuth_deg;
  const double elevation = kRadPerDeg * options.sun_elevation_deg;
  return {std::cos(elevation) * std::sin(azimuth), std::cos(elevation) * std::cos(azimuth),
          std::sin(elevation)};
}

Renderer::Renderer(const SyntheticScene& scene, const RenderOptions& options)
    : scene_(&scene),
      options_((validate(options), options)),
      rays_(scene.mesh),
      appearance_(scene,
                  hash(static_cast<std::uint32_t>(options.seed)),
                  static_cast<float>(options.texture)),
      to_sun_(sun_direction(options)),
      top_z_m_(top_z_m(scene.mesh)) {}

Spectrum Renderer::sky_light(const SurfacePoint& point) const {
  const auto level = static_cast<float>(kSkyShare * to_sun_.z());
  return level * (0.55F + 0.45F * point.normal.z()) * sky_colour() * point.reflectance;
}

Spectrum Renderer::sun_light(const SurfacePoint& point, const Eigen::Vector3d& direction) const {
  const float facing = std::max(point.normal.dot(to_sun_.cast<float>()), 0.0F);
  // light passes through leaves, so that their dark sides are not black
  const float cosine = point.leaf ? 0.25F + 0.75F * facing : facing;
  const auto along = static_cast<float>(-direction.dot(to_sun_));  // 1: sun behind the camera
  constexpr float kUsual = 0.7F;
  const float gain = 1.0F + static_cast<float>(options_.backscatter) * (along - kUsual);
  return gain * cosine * sun_colour() * point.reflectance;
}

Renderer::SurfacePoint Renderer::surface_point(const RayScene::Ray& ray,
                                               const std::optional<RayScene::Hit>& hit,
                                               float footprint_m) const {
  if (!hit) {  // the ground continues beyond the mesh
    const PlanFunction& ground = scene_->mean_terrain;
    const double height = ray.origin.z() - ground(ray.origin.head<2>());
    const double sinking = ground.gradient.dot(ray.direction.head<2>()) - ray.direction.z();
    const Eigen::Vector3d x = ray.origin + height / sinking * ray.direction;
    return {x, plane_of(ground).normal().cast<float>(), appearance_.lawn(x, footprint_m)};
  }
  const Triangle& triangle = scene_->mesh.triangles[static_cast<std::size_t>(hit->triangle)];
  SurfacePoint point{ray.origin + hit->distance_m * ray.direction,
                     appearance_.normal(hit->triangle), Spectrum::Zero(),
                     triangle.material == Material::kFoliage};
  point.reflectance = appearance_.reflectance(hit->triangle, point.x, footprint_m);
  const bool from_behind = point.normal.dot(ray.direction.cast<float>()) > 0.0F;
  if (from_behind && !point.leaf) point.normal = -point.normal;
  return point;
}

std::vector<Spectrum> Renderer::seen_along(std::span<const RayScene::Ray> rays,
                                           float footprint_m) const {
  const std::vector<std::optional<RayScene::Hit>> hits = rays_.first_hits(rays);
  std::vector<Spectrum> light(rays.size());
  std::vector<Spectrum> direct;  // sunlight on the points that face the sun
  std::vector<RayScene::Ray> to_sun;
  std::vector<std::size_t> facing;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const SurfacePoint point = surface_point(rays[i], hits[i], footprint_m);
    light[i] = sky_light(point);
    const Spectrum sun = sun_light(point, rays[i].direction);
    if (!(sun > 0.0F).any()) continue;
    direct.push_back(sun);
    facing.push_back(i);
    to_sun.push_back({point.x + kShadowOffsetM * point.normal.cast<double>(), to_sun_,
                      point.leaf ? kLeafClearanceM : 0.0});
  }
  const std::vector<char> shadowed = rays_.occluded(to_sun);
  for (std::size_t k = 0; k < facing.size(); ++k) {
    if (shadowed[k] == 0) light[facing[k]] += direct[k];
  }
  return light;
}

/// A band of rows of one view. Rays are also cast for the rows and columns just outside, because
/// their light spreads into the band.
class RowBlock {
 public:
  RowBlock(const Renderer& renderer,
           const AerialView& view,
           const PointSpread& spread,
           int first_row,
           int end_row)
      : renderer_(renderer),
        view_(view),
        in_village_(renderer.options_.samples_per_side),
        spread_(spread),
        first_row_(first_row),
        end_row_(end_row),
        columns_(view.size_px.x()),
        sums_(static_cast<std::size_t>(end_row - first_row) * static_cast<std::size_t>(columns_),
              WeightedSum{Spectrum::Zero(), 0.0F}) {}

  /// `radiance`: output, the rows of the block.
  void render(cv::Mat radiance) {
    constexpr int kReach = PointSpread::kReachPx;
    constexpr int kPixelsAtOnce = 16;
    for (int row = first_row_ - kReach; row < end_row_ + kReach; ++row) {
      for (int column = -kReach; column < columns_ + kReach; column += kPixelsAtOnce) {
        cast(row, column, std::min(column + kPixelsAtOnce, columns_ + kReach));
      }
    }
    for (int row = first_row_; row < end_row_; ++row) {
      auto* out = radiance.ptr<cv::Vec4f>(row - first_row_);
      for (int column = 0; column < columns_; ++column) {
        const WeightedSum& sum = sums_[index(row, column)];
        for (int band = 0; band < 4; ++band) out[column][band] = sum.light[band] / sum.weight;
      }
    }
  }

 private:
  struct WeightedSum {
    Spectrum light;
    float weight;
  };

  struct RayOrigin {
    int column, sub_x, sub_y;
  };

  [[nodiscard]] std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row - first_row_) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  /// Beyond the village there is only lawn without edges, where one ray per pixel is sufficient.
  [[nodiscard]] const SubPixelLattice& lattice(int row, int begin_column, int end_column) const {
    constexpr int kReach = PointSpread::kReachPx;
    const Eigen::AlignedBox2i& village = view_.village_px;
    const bool is_beyond = row < village.min().y() - kReach || row > village.max().y() + kReach ||
                           end_column <= village.min().x() - kReach ||
                           begin_column > village.max().x() + kReach;
    return is_beyond ? beyond_ : in_village_;
  }

  /// Casts the rays of some neighbouring pixels of a row. The lattice is shifted randomly from
  /// pixel to pixel, so that undersampling appears as noise rather than as a pattern.
  void cast(int row, int begin_column, int end_column) {
    const std::vector<SubPixelLattice::Position>& positions =
        lattice(row, begin_column, end_column).positions;
    rays_.clear();
    origins_.clear();
    for (int column = begin_column; column < end_column; ++column) {
      const std::uint32_t h =
          hash(row, column, static_cast<std::uint32_t>(renderer_.options_.seed));
      const int shift_x = static_cast<int>(h & 0xffU);
      const int shift_y = static_cast<int>((h >> 8U) & 0xffU);
      for (const SubPixelLattice::Position& position : positions) {
        const int sx = (position.x + shift_x) % kSubPixels;
        const int sy = (position.y + shift_y) % kSubPixels;
        origins_.push_back({column, sx, sy});
        rays_.push_back(
            ray({column + (sx + 0.5) / kSubPixels - 0.5, row + (sy + 0.5) / kSubPixels - 0.5}));
      }
    }
    const double way_m = (rays_.front().origin - view_.centre_in_local).norm();
    const double footprint_m =
        way_m * view_.pixel_angle_rad() / renderer_.options_.samples_per_side;
    const std::vector<Spectrum> light =
        renderer_.seen_along(rays_, static_cast<float>(footprint_m));
    for (std::size_t i = 0; i < light.size(); ++i) {
      const RayOrigin& from = origins_[i];
      add(row, from.column, spread_.at(from.sub_x), spread_.at(from.sub_y), light[i]);
    }
  }

  /// The ray of a pixel. It starts just above the scene, so that Embree's single precision is
  /// sufficient.
  [[nodiscard]] RayScene::Ray ray(const Eigen::Vector2d& x_px) const {
    const Eigen::Vector3d direction = view_.ray(x_px);
    const double way_m = (renderer_.top_z_m_ - view_.centre_in_local.z()) / direction.z();
    return {view_.centre_in_local + way_m * direction, direction};
  }

  /// The offsets from a pixel to those within reach whose index is in [begin, end).
  struct SplatSteps {
    int first, last;
  };
  static SplatSteps steps_within(int begin, int end, int at) {
    constexpr int kReach = PointSpread::kReachPx;
    return {std::max(-kReach, begin - at), std::min(kReach, end - 1 - at)};
  }

  void add(int row,
           int column,
           const PointSpread::Weights& along_x,
           const PointSpread::Weights& along_y,
           const Spectrum& light) {
    constexpr int kReach = PointSpread::kReachPx;
    const SplatSteps down = steps_within(first_row_, end_row_, row);
    const SplatSteps right = steps_within(0, columns_, column);
    for (int k = down.first; k <= down.last; ++k) {
      const int tap_y = k + kReach;
      const float weight_y = along_y[static_cast<std::size_t>(tap_y)];
      WeightedSum* sum = &sums_[index(row + k, column + right.first)];
      for (int i = right.first; i <= right.last; ++i, ++sum) {
        const int tap_x = i + kReach;
        const float weight = weight_y * along_x[static_cast<std::size_t>(tap_x)];
        sum->light += weight * light;
        sum->weight += weight;
      }
    }
  }

  const Renderer& renderer_;
  const AerialView& view_;
  SubPixelLattice in_village_;
  SubPixelLattice beyond_{1};
  const PointSpread& spread_;
  int first_row_, end_row_, columns_;
  std::vector<WeightedSum> sums_;
  std::vector<RayScene::Ray> rays_;
  std::vector<RayOrigin> origins_;  // one per ray
};

cv::Mat Renderer::radiance(const AerialView& view) const {
  return radiance(view, 0, view.size_px.y());
}

cv::Mat Renderer::radiance(const AerialView& view, int first_row, int end_row) const {
  constexpr int kRowsPerBlock = 32;
  check(0 <= first_row && first_row < end_row && end_row <= view.size_px.y(), "rows ", first_row,
        " to ", end_row, ", must be rows of the view");
  const PointSpread spread(kPointSpreadSigma_px);
  const int rows = end_row - first_row;
  cv::Mat result(rows, view.size_px.x(), CV_32FC4);
  const int blocks = (rows + kRowsPerBlock - 1) / kRowsPerBlock;
  tbb::parallel_for(0, blocks, [&](int block) {
    const int first = block * kRowsPerBlock;
    const int end = std::min(first + kRowsPerBlock, rows);
    RowBlock(*this, view, spread, first_row + first, first_row + end)
        .render(result.rowRange(first, end));
  });
  return result;
}

}  // namespace ridgeline::simulate
