// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/roof_details.h"

#include "tests/other_scenes/textures.h"

#include <array>
#include <cmath>

namespace ridgeline::other {
namespace {

using Eigen::Vector3d;

/// Coordinates on a main plane of a wing: along the eave from its middle, up the slope from it.
class OnRoof {
 public:
  OnRoof(const Wing& wing, double side) : wing_(wing), side_(side) {}

  [[nodiscard]] double height_m() const {
    return std::hypot(0.5 * wing_.width_m, wing_.ridge_m - wing_.eave_m);
  }
  /// `above_m` off the plane.
  [[nodiscard]] Vector3d at(double along_m, double up_m, double above_m) const {
    const double cosine = 0.5 * wing_.width_m / height_m();
    const double sine = (wing_.ridge_m - wing_.eave_m) / height_m();
    const double out = 0.5 * wing_.width_m - up_m * cosine + above_m * sine;
    return wing_.house_from_wing *
           Vector3d(along_m, side_ * out, wing_.eave_m + up_m * sine + above_m * cosine);
  }

 private:
  const Wing& wing_;
  double side_;
};

constexpr double kAboveRoof_m = 0.06;

struct RoofRectangle {
  double from_m, to_m, low_m, high_m;  ///< along the eave, up the slope
};

void add_plate(Solids& solids, const OnRoof& roof, const RoofRectangle& r, const Look& look) {
  const std::array<Vector3d, 4> c{
      roof.at(r.from_m, r.low_m, kAboveRoof_m), roof.at(r.to_m, r.low_m, kAboveRoof_m),
      roof.at(r.to_m, r.high_m, kAboveRoof_m), roof.at(r.from_m, r.high_m, kAboveRoof_m)};
  solids.begin_solid();
  solids.add_face({c[0], c[1], c[2], c[3]}, look);
  for (std::size_t i = 0; i < 4; ++i) solids.add_edge(c[i], c[(i + 1) % 4], "fitting");
}

}  // namespace

void add_dormer(Solids& solids, const Wing& wing, double side, double along_m, const Dormer& size) {
  constexpr double kSlope = 0.6;
  const double front_y = 0.5 * wing.width_m - wing.overhang_m - 1.0;
  const double front_eave_m = wing.roof_m(front_y) + size.front_height_m;
  const double ridge_m = front_eave_m + kSlope * 0.5 * size.width_m;
  const double back_y = (wing.ridge_m - ridge_m) / wing.slope();
  if (back_y < 0.8 || front_y - back_y < 1.0) return;
  constexpr double kInside_m = 0.5;
  const double from = back_y - kInside_m;
  const double to = front_y + size.overhang_m;
  Wing dormer = wing;
  dormer.length_m = to - from;
  dormer.width_m = size.width_m;
  dormer.overhang_m = size.overhang_m;
  dormer.eave_m = front_eave_m;
  dormer.ridge_m = ridge_m;
  dormer.hipped = {0.0, 0.0};
  dormer.walls = {Material::kWood, Vector3d(0.5, 0.47, 0.42), wing.roof.seed + 5U};
  dormer.house_from_wing = wing.house_from_wing *
                           Eigen::Translation3d(along_m, side * 0.5 * (from + to), 0.0) *
                           Eigen::AngleAxisd(side * 0.5 * M_PI, Vector3d::UnitZ());
  add_wing(solids, dormer);
}

void add_roof_window(Solids& solids, const Wing& wing, double side, double along_m, double up_m) {
  const OnRoof roof(wing, side);
  const Look frame{Material::kPaint, Vector3d(0.25, 0.25, 0.26), 1};
  const Look glass{Material::kGlass, Vector3d(0.07, 0.09, 0.11), 2};
  add_plate(solids, roof, {along_m - 0.4, along_m + 0.4, up_m, up_m + 1.2}, frame);
  const auto c = [&](double u, double v) { return roof.at(along_m + u, up_m + v, 0.09); };
  solids.add_face({c(-0.3, 0.1), c(0.3, 0.1), c(0.3, 1.1), c(-0.3, 1.1)}, glass);
}

void add_panels(Solids& solids, const Wing& wing, double side, std::uint64_t seed) {
  const OnRoof roof(wing, side);
  const double room_along_m = wing.length_m - 2.4;
  const double room_up_m = roof.height_m() - 1.4;
  const int columns = static_cast<int>(room_along_m / kModuleWidth_m);
  const int rows = static_cast<int>(room_up_m / kModuleHeight_m);
  if (columns < 2 || rows < 1) return;
  const double half_m = 0.5 * columns * kModuleWidth_m;
  const double low_m = 0.8;
  const double high_m = low_m + rows * kModuleHeight_m;
  const Look look{Material::kPanels, Vector3d(0.05, 0.06, 0.12), seed};
  add_plate(solids, roof, {-half_m, half_m, low_m, high_m}, look);
  for (int i = 1; i < columns; ++i) {
    const double u = i * kModuleWidth_m - half_m;
    solids.add_edge(roof.at(u, low_m, kAboveRoof_m), roof.at(u, high_m, kAboveRoof_m), "joint");
  }
  for (int i = 1; i < rows; ++i) {
    const double v = low_m + i * kModuleHeight_m;
    solids.add_edge(roof.at(-half_m, v, kAboveRoof_m), roof.at(half_m, v, kAboveRoof_m), "joint");
  }
}

void add_chimney(Solids& solids, const Wing& wing, RandomStream& random) {
  const double along_m = random.uniform(-0.3, 0.3) * wing.length_m;
  const double y = (random.chance(0.5) ? 1.0 : -1.0) * random.uniform(0.5, 1.3);
  const double half = random.uniform(0.25, 0.45);
  const Vector3d foot = wing.house_from_wing * Vector3d(along_m, y, wing.roof_m(y) - 0.8);
  const Vector3d head = foot + Vector3d(0.0, 0.0, 0.8 + random.uniform(0.9, 1.5));
  const Vector3d corner(half, 1.3 * half, 0.0);
  const Look brickwork{Material::kBrick, Vector3d(0.36, 0.20, 0.15), random.bits()};
  const Look cap{Material::kPaint, Vector3d(0.12, 0.12, 0.12), 3};
  solids.add_box({foot - corner, head + corner}, brickwork, cap, "chimney");
}

}  // namespace ridgeline::other
