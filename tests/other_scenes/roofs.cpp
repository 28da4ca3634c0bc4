// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/roofs.h"

#include "tests/other_scenes/textures.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ridgeline::other {
namespace {

using Eigen::Vector3d;

/// Points of one half of a wing with a ridge, turned to the side and end that they are of.
struct HalfWing {
  const Wing& wing;
  double end;     ///< -1 or 1: towards which x
  double hipped;  ///< share, at that end

  [[nodiscard]] double half_length() const { return 0.5 * wing.length_m; }
  [[nodiscard]] double hip_foot_m() const {
    return wing.ridge_m - hipped * (wing.ridge_m - wing.eave_m);
  }
  /// Hips are as steep as the main planes.
  [[nodiscard]] double setback() const { return 0.5 * hipped * wing.width_m; }
  [[nodiscard]] Vector3d eave(double side) const {
    return at(half_length(), 0.5 * side * wing.width_m, wing.eave_m);
  }
  [[nodiscard]] Vector3d hip_foot(double side) const {
    return at(half_length(), 0.5 * side * hipped * wing.width_m, hip_foot_m());
  }
  [[nodiscard]] Vector3d ridge() const { return at(half_length() - setback(), 0.0, wing.ridge_m); }
  [[nodiscard]] Vector3d at(double x, double y, double z) const {
    return wing.house_from_wing * Vector3d(end * x, y, z);
  }
};

/// A roof plane, its first side the eave, with the line where its tiles end at the gutter.
void add_roof_plane(Solids& solids, const std::vector<Vector3d>& corners, const Look& look) {
  solids.add_face(corners, look, true);
  if (look.material != Material::kTiles) return;
  const Vector3d along = (corners[1] - corners[0]).normalized();
  const Vector3d normal = along.cross(corners[2] - corners[0]).normalized();
  const Vector3d up = normal.cross(along);
  // the sides next to the eave rise from it for more than the width of the gutter
  const auto at_gutter = [&](const Vector3d& foot, const Vector3d& next) -> Vector3d {
    return foot + kGutter_m / up.dot(next - foot) * (next - foot);
  };
  solids.add_edge(at_gutter(corners[0], corners.back()), at_gutter(corners[1], corners[2]),
                  "joint");
}

void add_wing_end(Solids& solids, const HalfWing& half) {
  const bool has_verge = half.hipped < 1.0;
  for (const double side : {-1.0, 1.0}) {
    if (half.hipped > 0.0) solids.add_edge(half.hip_foot(side), half.ridge(), "hip");
    if (has_verge) solids.add_edge(half.eave(side), half.hip_foot(side), "verge");
  }
  if (half.hipped <= 0.0) return;
  solids.add_edge(half.hip_foot(-1.0), half.hip_foot(1.0), "eave");
  solids.add_face({half.hip_foot(-half.end), half.hip_foot(half.end), half.ridge()}, half.wing.roof,
                  true);
}

void add_main_plane(Solids& solids, const HalfWing& low, const HalfWing& high, double side) {
  const HalfWing& first = side < 0.0 ? low : high;
  const HalfWing& second = side < 0.0 ? high : low;
  std::vector<Vector3d> corners{first.eave(side), second.eave(side)};
  if (second.hipped > 0.0 && second.hipped < 1.0) corners.push_back(second.hip_foot(side));
  corners.push_back(second.ridge());
  if ((first.ridge() - second.ridge()).norm() > 1e-6) corners.push_back(first.ridge());
  if (first.hipped > 0.0 && first.hipped < 1.0) corners.push_back(first.hip_foot(side));
  add_roof_plane(solids, corners, low.wing.roof);
  solids.add_edge(first.eave(side), second.eave(side), "eave");
}

/// Up to just below the roof.
void add_end_wall(Solids& solids, const HalfWing& half) {
  constexpr double kBelow_m = 0.02;
  const Wing& wing = half.wing;
  const double x = half.half_length() - wing.overhang_m;
  const double y = 0.5 * wing.width_m - wing.overhang_m;
  const double hip_m = half.hip_foot_m() + wing.slope() * wing.overhang_m;
  const double top_m =
      (half.hipped > 0.0 ? std::min(wing.ridge_m, hip_m) : wing.ridge_m) - kBelow_m;
  const double side_m = std::min(top_m, wing.roof_m(y) - kBelow_m);
  const double top_y = std::min(y, (wing.ridge_m - kBelow_m - top_m) / wing.slope());
  std::vector<Vector3d> corners{half.at(x, -y, -kWallFoot_m), half.at(x, y, -kWallFoot_m),
                                half.at(x, y, side_m)};
  if (top_m > side_m + 1e-6) {
    corners.push_back(half.at(x, top_y, top_m));
    if (top_y > 1e-6) corners.push_back(half.at(x, -top_y, top_m));
  }
  corners.push_back(half.at(x, -y, side_m));
  solids.add_face(corners, wing.walls);
}

/// Borders of rows of windows are straight edges of long walls.
void add_window_edges(Solids& solids, const Wing& wing, double top_m, double side) {
  const double x = 0.5 * wing.length_m - wing.overhang_m;
  const double y = side * (0.5 * wing.width_m - wing.overhang_m);
  const int n_storeys = static_cast<int>(std::ceil(top_m / kStorey_m));
  for (int storey = 0; storey < n_storeys; ++storey) {
    const double floor_m = storey * kStorey_m;
    for (const double z : {floor_m + kWindowFoot_m, floor_m + kWindowHead_m}) {
      if (z > top_m) continue;
      solids.add_edge(wing.house_from_wing * Vector3d(-x, y, z),
                      wing.house_from_wing * Vector3d(x, y, z), "wall");
    }
  }
}

void add_side_wall(Solids& solids, const Wing& wing, double side, double top_m) {
  const double x = side * (0.5 * wing.length_m - wing.overhang_m);
  const double y = side * (0.5 * wing.width_m - wing.overhang_m);
  const auto at = [&](double along, double z) {
    return wing.house_from_wing * Vector3d(along, y, z);
  };
  solids.add_face({at(x, -kWallFoot_m), at(-x, -kWallFoot_m), at(-x, top_m), at(x, top_m)},
                  wing.walls);
  for (const double end : {-x, x}) solids.add_edge(at(end, -kWallFoot_m), at(end, top_m), "wall");
  add_window_edges(solids, wing, top_m, side);
}

/// Seams of a metal roof plane: `from`, `to` its lower corners, `rise` up its slope.
void add_seams(Solids& solids, const Vector3d& from, const Vector3d& to, const Vector3d& rise) {
  const Vector3d along = (to - from).normalized();
  const int n_sheets = static_cast<int>(std::ceil((to - from).norm() / kSeamPitch_m));
  for (int seam = 1; seam < n_sheets; ++seam) {
    for (const double border_m : {0.0, 0.05}) {
      const Vector3d foot = from + (seam * kSeamPitch_m + border_m) * along;
      solids.add_edge(foot, foot + rise, "joint");
    }
  }
}

}  // namespace

void add_wing(Solids& solids, const Wing& wing) {
  const HalfWing low{wing, -1.0, wing.hipped[0]};
  const HalfWing high{wing, 1.0, wing.hipped[1]};
  solids.begin_solid();
  for (const double side : {-1.0, 1.0}) add_main_plane(solids, low, high, side);
  for (const HalfWing& half : {low, high}) add_wing_end(solids, half);
  if ((low.ridge() - high.ridge()).norm() > 0.1) {
    solids.add_edge(low.ridge(), high.ridge(), "ridge");
  }
  if (wing.roof.material == Material::kMetal && wing.hipped[0] + wing.hipped[1] == 0.0) {
    add_seams(solids, low.eave(-1.0), high.eave(-1.0), low.ridge() - low.eave(-1.0));
    add_seams(solids, high.eave(1.0), low.eave(1.0), high.ridge() - high.eave(1.0));
  }
  solids.begin_solid();
  const double top_m = wing.roof_m(0.5 * wing.width_m - wing.overhang_m) - 0.02;
  for (const double side : {-1.0, 1.0}) add_side_wall(solids, wing, side, top_m);
  for (const HalfWing& half : {low, high}) add_end_wall(solids, half);
}

void add_shed(Solids& solids, const Wing& wing) {
  const double x = 0.5 * wing.length_m;
  const double y = 0.5 * wing.width_m;
  const auto at = [&](double along, double across, double z) {
    return wing.house_from_wing * Vector3d(along, across, z);
  };
  const std::array<Vector3d, 4> c{at(-x, -y, wing.eave_m), at(x, -y, wing.eave_m),
                                  at(x, y, wing.ridge_m), at(-x, y, wing.ridge_m)};
  solids.begin_solid();
  add_roof_plane(solids, {c[0], c[1], c[2], c[3]}, wing.roof);
  solids.add_edge(c[0], c[1], "eave");
  solids.add_edge(c[1], c[2], "verge");
  solids.add_edge(c[2], c[3], "eave");
  solids.add_edge(c[3], c[0], "verge");
  if (wing.roof.material == Material::kMetal) add_seams(solids, c[0], c[1], c[3] - c[0]);
  solids.begin_solid();
  const double rise = (wing.ridge_m - wing.eave_m) / wing.width_m * wing.overhang_m + 0.02;
  const double low_m = wing.eave_m + rise - 0.04;
  const double high_m = wing.ridge_m - rise;
  add_side_wall(solids, wing, -1.0, low_m);
  add_side_wall(solids, wing, 1.0, high_m);
  const double wx = x - wing.overhang_m;
  const double wy = y - wing.overhang_m;
  for (const double end : {-wx, wx}) {
    solids.add_face({at(end, -wy, -kWallFoot_m), at(end, wy, -kWallFoot_m), at(end, wy, high_m),
                     at(end, -wy, low_m)},
                    wing.walls);
  }
}

void add_flat(Solids& solids, const Wing& wing, double parapet_m) {
  constexpr double kThickness_m = 0.35;
  const double x = 0.5 * wing.length_m;
  const double y = 0.5 * wing.width_m;
  const double top_m = wing.ridge_m + parapet_m;
  const auto at = [&](double along, double across, double z) {
    return wing.house_from_wing * Vector3d(along, across, z);
  };
  const auto corner = [&](int i, double inset, double z) {
    const double sx = i == 1 || i == 2 ? 1.0 : -1.0;
    const double sy = i >= 2 ? 1.0 : -1.0;
    return at(sx * (x - inset), sy * (y - inset), z);
  };
  const Look cover{Material::kPaint, Vector3d(0.46, 0.47, 0.48), wing.roof.seed};
  solids.begin_solid();
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    solids.add_face({corner(i, 0.0, -kWallFoot_m), corner(j, 0.0, -kWallFoot_m),
                     corner(j, 0.0, top_m), corner(i, 0.0, top_m)},
                    wing.walls);
    solids.add_face({corner(i, 0.0, top_m), corner(j, 0.0, top_m), corner(j, kThickness_m, top_m),
                     corner(i, kThickness_m, top_m)},
                    cover, true);
    solids.add_face({corner(i, kThickness_m, wing.ridge_m), corner(j, kThickness_m, wing.ridge_m),
                     corner(j, kThickness_m, top_m), corner(i, kThickness_m, top_m)},
                    cover);
    solids.add_edge(corner(i, 0.0, top_m), corner(j, 0.0, top_m), "eave");
    solids.add_edge(corner(i, kThickness_m, top_m), corner(j, kThickness_m, top_m), "eave");
    solids.add_edge(corner(i, kThickness_m, wing.ridge_m), corner(j, kThickness_m, wing.ridge_m),
                    "fitting");
    solids.add_edge(corner(i, 0.0, -kWallFoot_m), corner(i, 0.0, top_m), "wall");
  }
  solids.add_face({corner(0, kThickness_m, wing.ridge_m), corner(1, kThickness_m, wing.ridge_m),
                   corner(2, kThickness_m, wing.ridge_m), corner(3, kThickness_m, wing.ridge_m)},
                  wing.roof, true);
}

}  // namespace ridgeline::other
