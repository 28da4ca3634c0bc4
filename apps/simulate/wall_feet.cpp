// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/wall_feet.h"

#include <algorithm>
#include <limits>

namespace ridgeline::simulate {
namespace {

constexpr double kOutwardsM = 1e-6;  // walls of neighbours coincide, so points outside are tested
constexpr double kMinFootLengthM = 0.5;
constexpr double kTouchingM = 1e-6;  // bodies that only touch do not rise above each other

/// One wall of a part, seen from outside.
struct StandingWall {
  const RoofPart& part;
  Segment2 foot;
  Segment2 outside;  ///< the same segment just outside

  StandingWall(const RoofPart& of, std::size_t side)
      : part(of), foot{of.walls[side], of.walls[(side + 1) % of.walls.size()]}, outside(foot) {
    const Eigen::Vector2d along = (foot.end - foot.start).normalized();
    const Eigen::Vector2d outwards = kOutwardsM * Eigen::Vector2d(along.y(), -along.x());
    outside = {foot.start + outwards, foot.end + outwards};
  }
};

PlanFunction lowered(PlanFunction height, double by_m) {
  height.offset -= by_m;
  return height;
}

/// Where the body of `part`, up to the underside of its roof, rises above `surface` along the
/// segment.
PlanInterval rises_above(const RoofPart& part,
                         const PlanFunction& surface,
                         const Segment2& segment) {
  PlanInterval interval = clip({}, segment, lowered(surface, part.base_z_m));
  for (const PlanFunction& top : part.tops) {
    interval = clip(interval, segment, lowered(top, part.slab_thickness_m + kTouchingM) - surface);
  }
  return interval;
}

class FootCollector {
 public:
  FootCollector(std::span<const RoofPart> parts, std::span<const PartFace> faces)
      : parts_(parts), faces_(faces) {}

  std::vector<SceneLine> collect(const GroundPlane& ground) {
    for (const RoofPart& part : parts_) {
      if (part.kind == PlaneKind::kChimney) continue;
      for (std::size_t side = 0; side < part.walls.size(); ++side) {
        const StandingWall wall(part, side);
        add(wall, PlanInterval{}, ground, kNone);
        for (const PartFace& face : faces_) add_on_roof(wall, face);
      }
    }
    return std::move(lines_);
  }

 private:
  void add_on_roof(const StandingWall& wall, const PartFace& face) {
    const RoofPart& lower = parts_[static_cast<std::size_t>(face.part)];
    if (&lower == &wall.part || lower.kind == PlaneKind::kChimney) return;
    PlanInterval interval;
    for (const PlanFunction& side : half_planes(face.cell.corners)) {
      interval = clip(interval, wall.outside, side);
    }
    if (!interval.empty()) add(wall, interval, {face.height, face.plane_id}, face.part);
  }

  /// Adds the pieces of a wall's foot on a surface (of the part `bearer`, or the ground) that no
  /// other part covers.
  void add(const StandingWall& wall, PlanInterval within, const GroundPlane& surface, int bearer) {
    const PlanInterval high = rises_above(wall.part, surface.height, wall.foot);
    within = {std::max(within.begin, high.begin), std::min(within.end, high.end)};
    if (within.empty()) return;
    std::vector<PlanInterval> pieces{within};
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const RoofPart& other = parts_[p];
      if (&other == &wall.part || static_cast<int>(p) == bearer) continue;
      PlanInterval hidden = rises_above(other, surface.height, wall.outside);
      for (const PlanFunction& side : half_planes(other.walls)) {
        hidden = clip(hidden, wall.outside, side);
      }
      pieces = subtract(pieces, hidden);
    }
    for (const PlanInterval& piece : pieces) add_line(wall, piece, surface);
  }

  void add_line(const StandingWall& wall, const PlanInterval& piece, const GroundPlane& surface) {
    const auto at = [&](double t) -> Eigen::Vector3d {
      const Eigen::Vector2d x = (1.0 - t) * wall.foot.start + t * wall.foot.end;
      return {x.x(), x.y(), surface.height(x)};
    };
    const Segment3 segment{at(piece.begin), at(piece.end)};
    if (length(segment) < kMinFootLengthM) return;
    lines_.push_back({.segment = segment,
                      .kind = LineKind::kFoot,
                      .plane_ids = {surface.plane_id},
                      .building_id = wall.part.building_id});
  }

  std::span<const RoofPart> parts_;
  std::span<const PartFace> faces_;
  std::vector<SceneLine> lines_;
};

}  // namespace

std::vector<SceneLine> wall_feet(std::span<const RoofPart> parts,
                                 std::span<const PartFace> faces,
                                 const GroundPlane& ground) {
  return FootCollector(parts, faces).collect(ground);
}

}  // namespace ridgeline::simulate
