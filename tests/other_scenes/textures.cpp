// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/textures.h"

#include "tests/other_scenes/noise.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::other {
namespace {

using Eigen::Vector3d;

std::int64_t cell(double x) { return static_cast<std::int64_t>(std::floor(x)); }
double fraction(double x) { return x - std::floor(x); }

/// Rows of tiles laid in half bond: each of its own shade, its lower edge in its own shadow, moss
/// and dirt over many of them, a zinc gutter along the eave.
Vector3d tiles(const Look& look, double u, double v) {
  constexpr double kRow_m = 0.34, kColumn_m = 0.26;
  if (v < kGutter_m) return {0.30, 0.31, 0.32};
  const std::int64_t row = cell(v / kRow_m);
  const double shift = (row & 1) != 0 ? 0.5 : 0.0;
  const double one = cell_noise(cell(u / kColumn_m + shift), row, look.seed) - 0.5;
  const double dirt = fractal_noise(0.7 * u, 0.45 * v, 4, look.seed + 9U);
  const double lip = fraction(v / kRow_m) < 0.16 ? 0.74 : 1.0;
  const double side = fraction(u / kColumn_m + shift) < 0.12 ? 0.9 : 1.0;
  return look.colour * (1.0 + 0.22 * one + 0.35 * dirt) * lip * side;
}

Vector3d metal(const Look& look, double u, double v) {
  constexpr double kSeam_m = 0.05;
  const double sheet = cell_noise(cell(u / kSeamPitch_m), 0, look.seed) - 0.5;
  const double streak = fractal_noise(3.0 * u, 0.15 * v, 3, look.seed + 3U);
  const double seam = fraction(u / kSeamPitch_m) * kSeamPitch_m < kSeam_m ? 0.62 : 1.0;
  return look.colour * (1.0 + 0.06 * sheet + 0.12 * streak) * seam;
}

/// Felt under gravel, with stains where water stands.
Vector3d bitumen(const Look& look, double u, double v) {
  const double grain = cell_noise(cell(u / 0.06), cell(v / 0.06), look.seed) - 0.5;
  const double stain = fractal_noise(0.35 * u, 0.35 * v, 4, look.seed + 5U);
  return look.colour * (1.0 + 0.45 * grain + 0.4 * std::min(stain, 0.1));
}

Vector3d plaster(const Look& look, double u, double v) {
  const double storey_v = fraction((v - kWallFoot_m) / kStorey_m) * kStorey_m;
  const double column = fraction(u / kWindowPitch_m) * kWindowPitch_m;
  const bool is_window = v > kWallFoot_m && storey_v > kWindowFoot_m && storey_v < kWindowHead_m &&
                         column > 0.8 && column < 2.0;
  if (is_window) return {0.09, 0.10, 0.12};
  return look.colour * (1.0 + 0.1 * fractal_noise(u, 2.0 * v, 3, look.seed));
}

Vector3d panels(const Look& look, double u, double v) {
  constexpr double kFrame_m = 0.06;
  const bool is_frame = fraction(u / kModuleWidth_m + 0.5 * kFrame_m) * kModuleWidth_m < kFrame_m ||
                        fraction(v / kModuleHeight_m + 0.5 * kFrame_m) * kModuleHeight_m < kFrame_m;
  if (is_frame) return {0.45, 0.46, 0.48};
  const double module =
      cell_noise(cell(u / kModuleWidth_m), cell(v / kModuleHeight_m), look.seed) - 0.5;
  return look.colour * (1.0 + 0.15 * module);
}

Vector3d brick(const Look& look, double u, double v) {
  const double one = cell_noise(cell(u / 0.24), cell(v / 0.08), look.seed) - 0.5;
  return look.colour * (1.0 + 0.3 * one);
}

Vector3d lawn(const GroundPatch& patch, const Eigen::Vector2d& x) {
  const double blades = cell_noise(cell(x.x() / 0.05), cell(x.y() / 0.05), patch.seed) - 0.5;
  const double tufts = fractal_noise(1.6 * x.x(), 1.6 * x.y(), 5, patch.seed + 1U);
  const double dry = std::max(0.0, fractal_noise(0.12 * x.x(), 0.12 * x.y(), 3, patch.seed + 2U));
  const Vector3d tint = (1.0 - dry) * patch.colour + dry * Vector3d(0.34, 0.30, 0.17);
  return tint * (1.0 + 0.35 * blades + 0.45 * tufts);
}

Vector3d field(const GroundPatch& patch, const Eigen::Vector2d& own) {
  const double furrow = 0.12 * std::sin(2.0 * M_PI * own.y() / 0.75);
  const double crumbs = fractal_noise(2.5 * own.x(), 6.0 * own.y(), 4, patch.seed);
  return patch.colour * (1.0 + furrow + 0.4 * crumbs);
}

Vector3d asphalt(const GroundPatch& patch, const Eigen::Vector2d& own) {
  const double grain = cell_noise(cell(own.x() / 0.04), cell(own.y() / 0.04), patch.seed) - 0.5;
  const double wear = fractal_noise(0.08 * own.x(), 0.9 * own.y(), 4, patch.seed + 1U);
  // places that were dug up and filled again
  const double repair =
      value_noise(0.11 * own.x(), 0.3 * own.y(), patch.seed + 2U) > 0.8 ? 0.85 : 1.0;
  return patch.colour * (1.0 + 0.25 * grain + 0.25 * wear) * repair;
}

Vector3d slabs(const GroundPatch& patch, const Eigen::Vector2d& own) {
  constexpr double kSlab_m = 0.5, kJoint = 0.08;
  const double one = cell_noise(cell(own.x() / kSlab_m), cell(own.y() / kSlab_m), patch.seed) - 0.5;
  const bool joint = fraction(own.x() / kSlab_m) < kJoint || fraction(own.y() / kSlab_m) < kJoint;
  const double dirt = fractal_noise(0.6 * own.x(), 0.6 * own.y(), 4, patch.seed + 4U);
  return patch.colour * (1.0 + 0.16 * one + 0.25 * dirt) * (joint ? 0.72 : 1.0);
}

Vector3d gravel(const GroundPatch& patch, const Eigen::Vector2d& x) {
  const double stones = fractal_noise(12.0 * x.x(), 12.0 * x.y(), 3, patch.seed);
  const double wear = fractal_noise(0.8 * x.x(), 0.8 * x.y(), 3, patch.seed + 7U);
  return patch.colour * (1.0 + 0.7 * stones + 0.2 * wear);
}

Vector3d marking(const GroundPatch& patch, const Eigen::Vector2d& own) {
  return patch.colour * (1.0 + 0.3 * fractal_noise(2.0 * own.x(), 8.0 * own.y(), 3, patch.seed));
}

}  // namespace

Vector3d reflectance(const Look& look, double u, double v) {
  switch (look.material) {
    case Material::kTiles:
      return tiles(look, u, v);
    case Material::kMetal:
      return metal(look, u, v);
    case Material::kBitumen:
      return bitumen(look, u, v);
    case Material::kPlaster:
      return plaster(look, u, v);
    case Material::kPanels:
      return panels(look, u, v);
    case Material::kBrick:
      return brick(look, u, v);
    case Material::kWood:
      return look.colour * (1.0 + 0.3 * fractal_noise(8.0 * u, 0.8 * v, 3, look.seed));
    default:
      return look.colour;
  }
}

Vector3d leaf_reflectance(const Look& look, const Vector3d& x) {
  const double leaves =
      fractal_noise(4.0 * (x.x() + 0.6 * x.z()), 4.0 * (x.y() - 0.5 * x.z()), 4, look.seed);
  const double branch =
      cell_noise(cell(x.x() / 0.11 + x.z()), cell(x.y() / 0.11 - x.z()), look.seed) - 0.5;
  return look.colour * std::max(0.15, 1.0 + 1.5 * leaves + 0.9 * branch);
}

Vector3d ground_reflectance(const Scene& scene, const Eigen::Vector2d& x) {
  const int index = patch_at(scene, x);
  if (index < 0) return {0.2, 0.25, 0.12};
  const GroundPatch& patch = scene.ground[index];
  const Eigen::Vector2d own = in_patch(patch, x);
  switch (patch.paving) {
    case Paving::kLawn:
      return lawn(patch, x);
    case Paving::kField:
      return field(patch, own);
    case Paving::kAsphalt:
      return asphalt(patch, own);
    case Paving::kSlabs:
      return slabs(patch, own);
    case Paving::kGravel:
      return gravel(patch, x);
    case Paving::kMarking:
      return marking(patch, own);
  }
  return patch.colour;
}

double gloss(Material material) {
  if (material == Material::kGlass) return 0.25;
  if (material == Material::kPaint || material == Material::kPanels) return 0.12;
  return material == Material::kMetal ? 0.06 : 0.0;
}

}  // namespace ridgeline::other
