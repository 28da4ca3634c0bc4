// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/geometry/check.h"
#include "reconstruct/geometry/degrees.h"
#include "tests/support/made_shell.h"

#include <cmath>

namespace ridgeline::test {
namespace {

using V = Eigen::Vector3d;

double tangent(double angle_deg) { return std::tan(angle_deg * kRadPerDeg); }

/// Half the sizes of a footprint, the height of its eaves and of its ridge.
struct Block {
  explicit Block(const BuildingSpec& spec)
      : x(0.5 * spec.length_m),
        y(0.5 * spec.width_m),
        slope(tangent(spec.pitch_deg)),
        eave(spec.eave_height_m),
        top(eave + slope * y) {}
  double x, y, slope, eave, top;
};

MadeShell gable(const Block& b) {
  MadeShell shell;
  shell.roof({V(-b.x, -b.y, b.eave), V(b.x, -b.y, b.eave), V(b.x, 0, b.top), V(-b.x, 0, b.top)});
  shell.roof({V(b.x, b.y, b.eave), V(-b.x, b.y, b.eave), V(-b.x, 0, b.top), V(b.x, 0, b.top)});
  return shell;
}

/// A hip roof whose ridge is shorter than the building by `run` at both ends; without a ridge its
/// four faces meet in a point.
void add_hip(MadeShell& shell, const Block& b, double run) {
  const V sw(-b.x, -b.y, b.eave), se(b.x, -b.y, b.eave), ne(b.x, b.y, b.eave),
      nw(-b.x, b.y, b.eave);
  const V west(run - b.x, 0, b.top), east(b.x - run, 0, b.top);
  if (west == east) {
    shell.roof({sw, se, east});
    shell.roof({ne, nw, west});
  } else {
    shell.roof({sw, se, east, west});
    shell.roof({ne, nw, west, east});
  }
  shell.roof({se, ne, east});
  shell.roof({nw, sw, west});
}

MadeShell hip(const Block& b) {
  check(b.x > b.y, "make_building: a hip roof must be longer than wide");
  MadeShell shell;
  add_hip(shell, b, b.y);
  return shell;
}

MadeShell pyramid(const Block& b) {
  MadeShell shell;
  add_hip(shell, b, b.x);
  return shell;
}

MadeShell half_hip(const Block& b) {
  const double y = 0.5 * b.y;  // where the hip begins
  check(b.x > y, "make_building: the half hips of a roof must not meet");
  const double z = b.top - b.slope * y;
  const V west(y - b.x, 0, b.top), east(b.x - y, 0, b.top);
  MadeShell shell;
  shell.roof(
      {V(-b.x, -b.y, b.eave), V(b.x, -b.y, b.eave), V(b.x, -y, z), east, west, V(-b.x, -y, z)});
  shell.roof({V(b.x, b.y, b.eave), V(-b.x, b.y, b.eave), V(-b.x, y, z), west, east, V(b.x, y, z)});
  shell.roof({V(b.x, -y, z), V(b.x, y, z), east});
  shell.roof({V(-b.x, y, z), V(-b.x, -y, z), west});
  return shell;
}

MadeShell mansard(Block b) {
  constexpr double kRise_m = 2.5;
  const double inset = kRise_m / tangent(60.0);
  check(b.x > b.y && b.y > inset, "make_building: a mansard roof must be longer and wider");
  const auto corner = [&](double sign_x, double sign_y, double by, double z) {
    return V(sign_x * (b.x - by), sign_y * (b.y - by), z);
  };
  MadeShell shell;
  const double signs[5][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  for (int i = 0; i < 4; ++i) {
    const auto& from = signs[i];
    const auto& to = signs[i + 1];
    shell.roof({corner(from[0], from[1], 0, b.eave), corner(to[0], to[1], 0, b.eave),
                corner(to[0], to[1], inset, b.eave + kRise_m),
                corner(from[0], from[1], inset, b.eave + kRise_m)});
  }
  b.x -= inset;
  b.y -= inset;
  b.eave += kRise_m;
  b.top = b.eave + b.slope * b.y;
  add_hip(shell, b, b.y);
  return shell;
}

MadeShell shed(const Block& b) {
  const double high = b.eave + 2.0 * b.slope * b.y;
  MadeShell shell;
  shell.roof({V(-b.x, -b.y, b.eave), V(b.x, -b.y, b.eave), V(b.x, b.y, high), V(-b.x, b.y, high)});
  return shell;
}

MadeShell flat(const Block& b) {
  constexpr double kParapet_m = 0.8, kThickness_m = 0.4;
  const auto ring = [&](double inset, double z) {
    const double x = b.x - inset, y = b.y - inset;
    return MadeRing{V(-x, -y, z), V(x, -y, z), V(x, y, z), V(-x, y, z)};
  };
  const MadeRing inner = ring(kThickness_m, b.eave);
  const MadeRing rim = ring(kThickness_m, b.eave + kParapet_m);
  MadeShell shell;
  shell.roof(inner);
  shell.roof(ring(0.0, b.eave + kParapet_m), MadeRing(rim.rbegin(), rim.rend()));
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t j = (i + 1) % 4;
    shell.wall({inner[j], inner[i], rim[i], rim[j]});
  }
  return shell;
}

MadeShell l_shape(const Block& b) {
  const double length = 2.0 * b.x, width = 2.0 * b.y;
  check(length > width, "make_building: the wings of an L must be longer than wide");
  const auto at = [&](double x, double y, double z) { return V(x - b.x, y - b.x, z); };
  const V inner = at(width, width, b.eave), outer = at(0, 0, b.eave), peak = at(b.y, b.y, b.top);
  const V east = at(length, b.y, b.top), north = at(b.y, length, b.top);
  MadeShell shell;
  shell.roof({outer, at(length, 0, b.eave), east, peak});
  shell.roof({at(length, width, b.eave), inner, peak, east});
  shell.roof({inner, at(width, length, b.eave), north, peak});
  shell.roof({at(0, length, b.eave), outer, peak, north});
  return shell;
}

MadeShell t_shape(const Block& b) {
  const double x = 0.7 * b.y, y = -b.y - 1.2 * b.y;  // the wing: half its width, its gable
  check(b.x > x, "make_building: a T must be longer than its wing is wide");
  const double top = b.eave + b.slope * x;
  const V peak(0, x - b.y, top), west(-x, -b.y, b.eave), east(x, -b.y, b.eave),
      gable_top(0, y, top);
  MadeShell shell;
  shell.roof({V(-b.x, -b.y, b.eave), west, peak, east, V(b.x, -b.y, b.eave), V(b.x, 0, b.top),
              V(-b.x, 0, b.top)});
  shell.roof({V(b.x, b.y, b.eave), V(-b.x, b.y, b.eave), V(-b.x, 0, b.top), V(b.x, 0, b.top)});
  shell.roof({V(-x, y, b.eave), gable_top, peak, west});
  shell.roof({gable_top, V(x, y, b.eave), east, peak});
  return shell;
}

MadeShell dormer(const Block& b) {
  constexpr double x = 1.25, kFront_m = 0.8,
                   kWall_m = 0.9;  // half its width, set back from the eave, height of its front
  const double front = kFront_m - b.y, foot = b.eave + b.slope * kFront_m;
  const double eave = foot + kWall_m, top = eave + b.slope * x;
  const double eave_end = front + kWall_m / b.slope, top_end = eave_end + x;
  check(top_end < 0.0 && b.x > x,
        "make_building: the roof is too small or too flat for its dormer");
  const V sw(-x, front, foot), se(x, front, foot), west(-x, front, eave), east(x, front, eave);
  const V nw(-x, eave_end, eave), ne(x, eave_end, eave), peak(0, front, top), end(0, top_end, top);
  MadeShell shell = gable(b);
  shell.faces[0].rings.push_back({sw, nw, end, ne, se});
  shell.roof({west, peak, end, nw});
  shell.roof({peak, east, ne, end});
  shell.wall({sw, se, east, peak, west});
  shell.wall({sw, west, nw});
  shell.wall({east, se, ne});
  return shell;
}

/// Complete with walls: its border is not one ring.
MadeShell annex(const Block& b) {
  constexpr double kDepth_m = 3.0, kBelowEave_m = 0.5;
  const double x = 0.6 * b.x, y = b.y + kDepth_m;
  const double high = b.eave - kBelowEave_m, low = high - kDepth_m * tangent(15.0);
  check(low > 0.0, "make_building: the eaves are too low for a lean-to");
  const V sw(-b.x, -b.y, b.eave), se(b.x, -b.y, b.eave), ne(b.x, b.y, b.eave),
      nw(-b.x, b.y, b.eave);
  const V west(-x, b.y, high), east(x, b.y, high), west_low(-x, y, low), east_low(x, y, low);
  const auto foot = [](const V& v) { return V(v.x(), v.y(), 0.0); };
  MadeShell shell = gable(b);
  const V top_west(-b.x, 0, b.top), top_east(b.x, 0, b.top);
  shell.roof({west, east, east_low, west_low});
  shell.wall({foot(sw), foot(se), se, sw});
  shell.wall({foot(se), foot(ne), ne, top_east, se});
  shell.wall({foot(nw), foot(sw), sw, top_west, nw});
  shell.wall({foot(ne), foot(east), east, west, foot(west), foot(nw), nw, ne});
  shell.wall({foot(east), foot(east_low), east_low, east});
  shell.wall({foot(west_low), foot(west), west, west_low});
  shell.wall({foot(east_low), foot(west_low), west_low, east_low});
  shell.ground({foot(sw), foot(se), foot(ne), foot(east), foot(east_low), foot(west_low),
                foot(west), foot(nw)});
  return shell;
}

MadeShell roof_of(RoofShape shape, const Block& block) {
  switch (shape) {
    case RoofShape::kHip:
      return hip(block);
    case RoofShape::kPyramid:
      return pyramid(block);
    case RoofShape::kHalfHip:
      return half_hip(block);
    case RoofShape::kMansard:
      return mansard(block);
    case RoofShape::kShed:
      return shed(block);
    case RoofShape::kFlat:
      return flat(block);
    case RoofShape::kLShape:
      return l_shape(block);
    case RoofShape::kTShape:
      return t_shape(block);
    case RoofShape::kDormer:
      return dormer(block);
    case RoofShape::kAnnex:
      return annex(block);
    case RoofShape::kGable:
      break;
  }
  return gable(block);
}

}  // namespace

MadeShell shell_of(const BuildingSpec& spec) {
  MadeShell shell = roof_of(spec.shape, Block(spec));
  if (spec.shape != RoofShape::kAnnex) shell.close_to_ground();
  return shell;
}

}  // namespace ridgeline::test
