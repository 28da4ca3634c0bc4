// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/render.h"

#include "apps/simulate/noise.h"
#include "apps/simulate/point_spread.h"

#include <Eigen/Geometry>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace ridgeline::simulate {
namespace {

constexpr double kShadowOffsetM = 2e-3;  // off the surface itself; Embree's float is good to 0.1 mm

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
  constexpr double kRadPerDeg = std::numbers::pi / 180.0;
  const double azimuth = kRadPerDeg * options.sun_azimuth_deg;
  const double elevation = kRadPerDeg * options.sun_elevation_deg;
  return {std::cos(elevation) * std::sin(azimuth), std::cos(elevation) * std::cos(azimuth),
          std::sin(elevation)};
}

Renderer::Renderer(const Scene& scene, const RenderOptions& options)
    : scene_(&scene),
      options_((validate(options), options)),
      rays_(scene.mesh),
      appearance_(scene, hash(static_cast<std::uint32_t>(options.seed))),
      to_sun_(sun_direction(options)),
      top_z_m_(top_z_m(scene.mesh)) {}

Spectrum Renderer::lit(const Eigen::Vector3d& x,
                       const Eigen::Vector3f& normal,
                       const Eigen::Vector3d& direction,
                       const Spectrum& reflectance,
                       bool leaf) const {
  const float facing = normal.dot(to_sun_.cast<float>());
  // light passes leaves, so that their dark sides are not black
  const float cosine = leaf ? 0.25F + 0.75F * std::max(facing, 0.0F) : std::max(facing, 0.0F);
  const double clearance_m = leaf ? 0.05 : 0.0;  // a leaf does not shadow itself
  Spectrum light = static_cast<float>(options_.sky_share * to_sun_.z()) * sky_colour() *
                   (0.55F + 0.45F * normal.z());
  const Eigen::Vector3d start = x + kShadowOffsetM * normal.cast<double>();
  if (cosine > 0.0F && !rays_.occluded(start, to_sun_, clearance_m)) {
    const auto along = static_cast<float>(-direction.dot(to_sun_));  // 1: the sun behind the camera
    const float gain = 1.0F + static_cast<float>(options_.backscatter) * (along - 0.7F);
    light += gain * cosine * sun_colour();
  }
  return reflectance * light;
}

Spectrum Renderer::seen_along(const Eigen::Vector3d& origin,
                              const Eigen::Vector3d& direction,
                              float footprint_m) const {
  const auto hit = rays_.first_hit(origin, direction);
  if (!hit) {  // the ground goes on beyond the mesh
    const PlanFunction& ground = scene_->mean_terrain;
    const double height = origin.z() - ground(origin.head<2>());
    const double sinking = ground.gradient.dot(direction.head<2>()) - direction.z();
    const Eigen::Vector3d x = origin + height / sinking * direction;
    const Eigen::Vector3d up(-ground.gradient.x(), -ground.gradient.y(), 1.0);
    return lit(x, up.normalized().cast<float>(), direction, appearance_.lawn(x, footprint_m),
               false);
  }
  const Eigen::Vector3d x = origin + hit->distance_m * direction;
  const bool leaf = scene_->mesh.triangles[static_cast<std::size_t>(hit->triangle)].material ==
                    Material::kFoliage;
  Eigen::Vector3f normal = appearance_.normal(hit->triangle);
  if (!leaf && normal.dot(direction.cast<float>()) > 0.0F) normal = -normal;
  return lit(x, normal, direction, appearance_.reflectance(hit->triangle, x, footprint_m), leaf);
}

/// A band of rows of one view. The rays of the rows and columns just outside are cast too, since
/// their light spreads into the band.
class RowBlock {
 public:
  RowBlock(const Renderer& renderer,
           const AerialView& view,
           const SubPixelLattice& lattice,
           const PointSpread& spread,
           int first_row,
           int end_row)
      : renderer_(renderer),
        view_(view),
        lattice_(lattice),
        spread_(spread),
        first_row_(first_row),
        end_row_(end_row),
        columns_(view.size_px.x()),
        sums_(static_cast<std::size_t>(end_row - first_row) * static_cast<std::size_t>(columns_),
              Sum{Spectrum::Zero(), 0.0F}) {}

  void render(cv::Mat& radiance) {
    constexpr int kReach = PointSpread::kReachPx;
    for (int row = first_row_ - kReach; row < end_row_ + kReach; ++row) {
      for (int column = -kReach; column < columns_ + kReach; ++column) cast_pixel(row, column);
    }
    for (int row = first_row_; row < end_row_; ++row) {
      auto* out = radiance.ptr<cv::Vec4f>(row);
      for (int column = 0; column < columns_; ++column) {
        const Sum& sum = sums_[index(row, column)];
        for (int band = 0; band < 4; ++band) out[column][band] = sum.light[band] / sum.weight;
      }
    }
  }

 private:
  struct Sum {
    Spectrum light;
    float weight;
  };

  [[nodiscard]] std::size_t index(int row, int column) const {
    return static_cast<std::size_t>(row - first_row_) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  /// The lattice is shifted at random from pixel to pixel: what the rays miss is noise, no pattern.
  void cast_pixel(int row, int column) {
    const std::uint32_t h = hash(row, column, static_cast<std::uint32_t>(renderer_.options_.seed));
    const int shift_x = static_cast<int>(h & 0xffU);
    const int shift_y = static_cast<int>((h >> 8U) & 0xffU);
    for (const SubPixelLattice::Position& position : lattice_.positions) {
      const int sx = (position.x + shift_x) % kSubPixels;
      const int sy = (position.y + shift_y) % kSubPixels;
      const Eigen::Vector2d x_px(column + (sx + 0.5) / kSubPixels - 0.5,
                                 row + (sy + 0.5) / kSubPixels - 0.5);
      add(row, column, spread_.at(sx), spread_.at(sy), cast(x_px));
    }
  }

  [[nodiscard]] Spectrum cast(const Eigen::Vector2d& x_px) const {
    const Eigen::Vector3d direction = view_.ray(x_px);
    // from just above the scene, where Embree's single precision is enough
    const double way_m = (renderer_.top_z_m_ - view_.centre_in_local.z()) / direction.z();
    const Eigen::Vector3d origin = view_.centre_in_local + way_m * direction;
    const double pixel_m = way_m * view_.ray_from_pixel.col(0).norm();
    return renderer_.seen_along(origin, direction,
                                static_cast<float>(pixel_m / renderer_.options_.samples_per_side));
  }

  void add(int row,
           int column,
           const PointSpread::Weights& along_x,
           const PointSpread::Weights& along_y,
           const Spectrum& light) {
    constexpr int kReach = PointSpread::kReachPx;
    for (int k = -kReach; k <= kReach; ++k) {
      if (row + k < first_row_ || row + k >= end_row_) continue;
      for (int i = -kReach; i <= kReach; ++i) {
        if (column + i < 0 || column + i >= columns_) continue;
        const float weight = along_y[static_cast<std::size_t>(k + kReach)] *
                             along_x[static_cast<std::size_t>(i + kReach)];
        Sum& sum = sums_[index(row + k, column + i)];
        sum.light += weight * light;
        sum.weight += weight;
      }
    }
  }

  const Renderer& renderer_;
  const AerialView& view_;
  const SubPixelLattice& lattice_;
  const PointSpread& spread_;
  int first_row_, end_row_, columns_;
  std::vector<Sum> sums_;
};

cv::Mat Renderer::radiance(const AerialView& view) const {
  constexpr int kRowsPerBlock = 32;
  const SubPixelLattice lattice(options_.samples_per_side);
  const PointSpread spread(options_.psf_sigma_px);
  const int rows = view.size_px.y();
  cv::Mat result(rows, view.size_px.x(), CV_32FC4);
  const int blocks = (rows + kRowsPerBlock - 1) / kRowsPerBlock;
  tbb::parallel_for(0, blocks, [&](int block) {
    const int first = block * kRowsPerBlock;
    RowBlock(*this, view, lattice, spread, first, std::min(first + kRowsPerBlock, rows))
        .render(result);
  });
  return result;
}

}  // namespace ridgeline::simulate
