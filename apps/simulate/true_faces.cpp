// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/true_faces.h"

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ridgeline::simulate {
namespace {

namespace bg = boost::geometry;
using PlanPoint = bg::model::d2::point_xy<double>;
constexpr bool kClockwise = true;
using PlanPolygon = bg::model::polygon<PlanPoint, !kClockwise>;
using PlanPolygons = bg::model::multi_polygon<PlanPolygon>;

constexpr double kSameM = 1e-6;  // vertices this close are merged; rounding errors are about 1e-8
// at a mitre, a probe next to the wall misses the neighbour
constexpr double kMinWallLengthM = 1e-4;
constexpr double kSliverM2 = 1e-4;  // slivers between outlines that touch

PlanPolygon plan_polygon(const ConvexPolygon& corners) {
  PlanPolygon polygon;
  for (const Eigen::Vector2d& x : corners) bg::append(polygon, PlanPoint(x.x(), x.y()));
  bg::correct(polygon);
  return polygon;
}

/// Removes vertices from a ring that repeat their neighbour or lie on the line between their
/// neighbours.
std::vector<Eigen::Vector3d> tidied(std::vector<Eigen::Vector3d> ring) {
  for (std::size_t i = 0; i < ring.size() && ring.size() > 2;) {
    const Eigen::Vector3d& before = ring[(i + ring.size() - 1) % ring.size()];
    const Eigen::Vector3d& after = ring[(i + 1) % ring.size()];
    const Eigen::Vector3d along = (after - before).normalized();
    const Eigen::Vector3d to = ring[i] - before;
    const bool is_needless = to.norm() < kSameM || (to - along * along.dot(to)).norm() < kSameM;
    if (is_needless) {
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(i));
      i = 0;  // its neighbours have new neighbours
    } else {
      ++i;
    }
  }
  return ring;
}

/// Lifts a plan polygon onto a surface; empty if it is a sliver. Slivers among its holes are left
/// out.
std::vector<std::vector<Eigen::Vector3d>> lifted_rings(const PlanPolygon& polygon,
                                                       const PlanFunction& height) {
  std::vector<std::vector<Eigen::Vector3d>> rings;
  const auto add = [&](const PlanPolygon::ring_type& ring) {
    if (std::abs(bg::area(ring)) < kSliverM2) return;
    std::vector<Eigen::Vector3d> corners;
    for (std::size_t i = 0; i + 1 < ring.size(); ++i) {  // the last vertex repeats the first
      const Eigen::Vector2d x(ring[i].x(), ring[i].y());
      corners.emplace_back(x.x(), x.y(), height(x));
    }
    corners = tidied(std::move(corners));
    if (corners.size() > 2) rings.push_back(std::move(corners));
  };
  add(polygon.outer());
  if (rings.empty()) return rings;
  for (const PlanPolygon::ring_type& hole : polygon.inners()) add(hole);
  return rings;
}

double top_of(const RoofPart& part, const Eigen::Vector2d& x) {
  double z = part.tops.front()(x);
  for (const PlanFunction& top : part.tops) z = std::min(z, top(x));
  return z;
}

/// The lower and upper boundary of a wall face, built up piece by piece along the wall.
struct WallProfile {
  std::vector<Eigen::Vector3d> lower, upper;
};

class FaceCollector {
 public:
  FaceCollector(std::span<const RoofPart> parts, std::span<const PartFace> roof_faces)
      : parts_(parts), roof_faces_(roof_faces) {}

  std::vector<Face> collect() {
    for (const PartFace& face : roof_faces_) add_roof(face);
    for (const RoofPart& part : parts_) {
      for (std::size_t i = 0; i < part.walls.size(); ++i) add_wall(part, i);
    }
    std::vector<int> ids;
    for (const RoofPart& part : parts_) {
      if (std::ranges::find(ids, part.building_id) == ids.end()) ids.push_back(part.building_id);
    }
    for (const int id : ids) add_ground(id);
    std::ranges::stable_sort(faces_, {}, &Face::building);
    return std::move(faces_);
  }

 private:
  /// The other parts of the building to which a part belongs, without chimneys.
  [[nodiscard]] std::vector<const RoofPart*> others(const RoofPart& part) const {
    std::vector<const RoofPart*> found;
    for (const RoofPart& other : parts_) {
      const bool counts =
          other.building_id == part.building_id && other.kind != PlaneKind::kChimney;
      if (counts && &other != &part) found.push_back(&other);
    }
    return found;
  }

  void add(std::vector<std::vector<Eigen::Vector3d>> rings, FaceKind kind, int building_id) {
    if (!rings.empty()) {
      faces_.push_back({std::move(rings), kind, static_cast<std::size_t>(building_id), ""});
    }
  }

  void add_roof(const PartFace& face) {
    const RoofPart& part = parts_[static_cast<std::size_t>(face.part)];
    if (part.kind == PlaneKind::kChimney) return;
    PlanPolygons seen;
    seen.push_back(plan_polygon(face.cell.corners));
    for (const RoofPart* other : others(part)) {
      std::vector<PlanFunction> above;
      for (const PlanFunction& top : other->tops) above.push_back(top - face.height);
      const ConvexPolygon cover = clip(other->outline, above);
      if (cover.empty()) continue;
      PlanPolygons rest;
      bg::difference(seen, plan_polygon(cover), rest);
      seen = std::move(rest);
    }
    for (const PlanPolygon& polygon : seen)
      add(lifted_rings(polygon, face.height), FaceKind::kRoof, part.building_id);
  }

  /// Where another part hides the foot of a wall: where points just outside the wall are inside
  /// that part.
  static PlanInterval hidden_interval(const RoofPart& other, const Segment2& wall) {
    const Eigen::Vector2d along = (wall.end - wall.start).normalized();
    const Eigen::Vector2d outwards = kSameM * Eigen::Vector2d(along.y(), -along.x());
    const Segment2 beside{wall.start + outwards, wall.end + outwards};
    PlanInterval interval;
    for (const PlanFunction& side : half_planes(other.walls))
      interval = clip(interval, beside, side);
    return interval;
  }

  /// The positions along a wall, 0 to 1, between which its upper and lower borders are straight.
  static std::vector<double> breaks_of(const Segment2& wall,
                                       const RoofPart& part,
                                       const std::vector<const RoofPart*>& hiding) {
    std::vector<PlanFunction> heights = part.tops;
    std::vector<double> breaks{0.0, 1.0};
    for (const RoofPart* other : hiding) {
      heights.insert(heights.end(), other->tops.begin(), other->tops.end());
      const PlanInterval interval = hidden_interval(*other, wall);
      breaks.insert(breaks.end(), {interval.begin, interval.end});
    }
    heights.push_back({Eigen::Vector2d::Zero(), part.base_z_m});
    for (std::size_t i = 0; i < heights.size(); ++i) {
      for (std::size_t k = i + 1; k < heights.size(); ++k) {
        const PlanFunction difference = heights[i] - heights[k];
        const double slope = difference.gradient.dot(wall.end - wall.start);
        if (slope != 0.0) breaks.push_back(-difference(wall.start) / slope);
      }
    }
    std::erase_if(breaks, [](double t) { return !(t >= 0.0 && t <= 1.0); });
    std::ranges::sort(breaks);
    return breaks;
  }

  void add_wall(const RoofPart& part, std::size_t side) {
    if (part.kind == PlaneKind::kChimney) return;
    const Segment2 wall{part.walls[side], part.walls[(side + 1) % part.walls.size()]};
    const std::vector<const RoofPart*> hiding = others(part);
    const std::vector<double> breaks = breaks_of(wall, part, hiding);
    WallProfile profile;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
      if ((breaks[i + 1] - breaks[i]) * length(wall) < kMinWallLengthM) continue;
      if (!extend(part, wall, hiding, {breaks[i], breaks[i + 1]}, profile)) flush(part, profile);
    }
    flush(part, profile);
  }

  /// Adds the visible part of a piece of a wall to the profile; false if there is none.
  static bool extend(const RoofPart& part,
                     const Segment2& wall,
                     const std::vector<const RoofPart*>& hiding,
                     const PlanInterval& piece,
                     WallProfile& profile) {
    const auto at = [&](double t) -> Eigen::Vector2d {
      return (1.0 - t) * wall.start + t * wall.end;
    };
    const double middle = 0.5 * (piece.begin + piece.end);
    const auto foot = [&](double t) {
      double z = part.base_z_m;
      for (const RoofPart* other : hiding) {
        const PlanInterval hidden = hidden_interval(*other, wall);
        if (!hidden.empty() && hidden.begin < middle && middle < hidden.end)
          z = std::max(z, top_of(*other, at(t)));
      }
      return z;
    };
    if (top_of(part, at(middle)) - foot(middle) < kSameM) return false;
    for (const double t : {piece.begin, piece.end}) {
      const Eigen::Vector2d x = at(t);
      profile.lower.emplace_back(x.x(), x.y(), foot(t));
      profile.upper.emplace_back(x.x(), x.y(), top_of(part, x));
    }
    return true;
  }

  void flush(const RoofPart& part, WallProfile& profile) {
    std::vector<Eigen::Vector3d> ring = std::move(profile.lower);
    ring.insert(ring.end(), profile.upper.rbegin(), profile.upper.rend());
    profile = {};
    ring = tidied(std::move(ring));
    if (ring.size() > 2) add({std::move(ring)}, FaceKind::kWall, part.building_id);
  }

  /// Adds the ground below the walls of all parts, merged because the walls of a dormer are within
  /// those of other parts.
  void add_ground(int building_id) {
    double base_z_m = std::numeric_limits<double>::infinity();
    PlanPolygons plan;
    for (const RoofPart& part : parts_) {
      if (part.building_id != building_id || part.kind == PlaneKind::kChimney) continue;
      base_z_m = std::min(base_z_m, part.base_z_m);
      PlanPolygons sum;
      bg::union_(plan, plan_polygon(part.walls), sum);
      plan = std::move(sum);
    }
    for (const PlanPolygon& polygon : plan) {
      auto rings = lifted_rings(polygon, {Eigen::Vector2d::Zero(), base_z_m});
      for (std::vector<Eigen::Vector3d>& ring : rings)
        std::ranges::reverse(ring);  // its outer side faces down
      add(std::move(rings), FaceKind::kGround, building_id);
    }
  }

  std::span<const RoofPart> parts_;
  std::span<const PartFace> roof_faces_;
  std::vector<Face> faces_;
};

}  // namespace

std::vector<Face> true_faces(std::span<const RoofPart> parts,
                             std::span<const PartFace> roof_faces) {
  return FaceCollector(parts, roof_faces).collect();
}

}  // namespace ridgeline::simulate
