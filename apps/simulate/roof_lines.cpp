// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/roof_lines.h"

#include <algorithm>
#include <cmath>

namespace ridgeline::simulate {
namespace {

constexpr double kRoofTouchM = 1e-7;          // bodies that only touch do not cover each other
constexpr double kMinRoofLineLengthM = 0.01;  // shorter slivers are ignored
constexpr double kHorizontalM = 1e-9;         // height difference along a line

/// Where `part` rises above `height` along the segment. This is a single interval, because the
/// outline and planes of the part are half-planes. It is empty if the two only touch.
PlanInterval covered_interval(const RoofPart& part,
                              const Segment2& segment,
                              const PlanFunction& height) {
  std::vector<PlanFunction> conditions = half_planes(part.outline);
  for (const PlanFunction& top : part.tops) conditions.push_back(top - height);
  PlanInterval interval;
  for (const PlanFunction& inside : conditions) interval = clip(interval, segment, inside);
  const double middle = 0.5 * (interval.begin + interval.end);
  const Eigen::Vector2d x = (1.0 - middle) * segment.start + middle * segment.end;
  const bool deep =
      std::all_of(conditions.begin(), conditions.end(),
                  [&](const PlanFunction& inside) { return inside(x) > kRoofTouchM; });
  return deep ? interval : PlanInterval{0.0, 0.0};
}

Segment3 lifted(const Segment2& segment, const PlanInterval& interval, const PlanFunction& height) {
  const auto at = [&](double t) -> Eigen::Vector3d {
    const Eigen::Vector2d x = (1.0 - t) * segment.start + t * segment.end;
    return {x.x(), x.y(), height(x)};
  };
  return {at(interval.begin), at(interval.end)};
}

class LineCollector {
 public:
  LineCollector(std::span<const RoofPart> parts, std::span<const PartFace> faces)
      : parts_(parts), faces_(faces) {}

  std::vector<SceneLine> collect() {
    for (const PartFace& face : faces_) {
      add_sides(face);
      add_joints(face);
    }
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      for (std::size_t k = i + 1; k < faces_.size(); ++k) add_valley(faces_[i], faces_[k]);
    }
    return std::move(lines_);
  }

 private:
  [[nodiscard]] const RoofPart& part_of(const PartFace& face) const {
    return parts_[static_cast<std::size_t>(face.part)];
  }

  /// Adds the borders of the face within its own part: its outline, ridges and hips.
  void add_sides(const PartFace& face) {
    const std::size_t n = face.cell.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Segment2 side{face.cell.corners[i], face.cell.corners[(i + 1) % n]};
      const int label = face.cell.labels[i];
      const bool level = std::abs(face.height(side.end) - face.height(side.start)) < kHorizontalM;
      if (label < 0) {
        const PartFace* other = neighbour(face, -1 - label);
        if (other == nullptr || other->plane_id < face.plane_id) continue;  // the other adds it
        add(side, face, level ? LineKind::kRidge : LineKind::kHip, other);
      } else if (is_joint(face, label)) {
        add(side, face, LineKind::kJoint, nullptr);
      } else {
        add(side, face, level ? LineKind::kEave : LineKind::kVerge, nullptr);
      }
    }
  }

  /// Adds the joints where walls of higher parts meet the face.
  void add_joints(const PartFace& face) {
    const std::vector<PlanFunction> cell = half_planes(face.cell.corners);
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      if (static_cast<int>(p) == face.part) continue;
      const ConvexPolygon& outline = parts_[p].outline;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const Segment2 side{outline[i], outline[(i + 1) % outline.size()]};
        PlanInterval interval;
        for (const PlanFunction& inside : cell) interval = clip(interval, side, inside);
        for (const PlanFunction& top : parts_[p].tops) {
          interval = clip(interval, side, top - face.height);
        }
        if (interval.empty()) continue;
        const Segment3 piece = lifted(side, interval, face.height);
        add(plan(piece), face, LineKind::kJoint, nullptr);
      }
    }
  }

  void add_valley(const PartFace& a, const PartFace& b) {
    if (a.part == b.part || part_of(b).kind == PlaneKind::kChimney) return;
    const auto line = intersection(a.height, a.cell.corners, b.height, b.cell.corners);
    if (line) add(*line, a, LineKind::kValley, &b);
  }

  [[nodiscard]] const PartFace* neighbour(const PartFace& face, int top) const {
    for (const PartFace& other : faces_) {
      if (other.part == face.part && other.top == top) return &other;
    }
    return nullptr;
  }

  [[nodiscard]] bool is_joint(const PartFace& face, int side) const {
    const std::vector<bool>& flags = part_of(face).is_joint;
    return !flags.empty() && flags[static_cast<std::size_t>(side)];
  }

  /// Adds the pieces of the segment that are not covered by a third part.
  void add(const Segment2& segment, const PartFace& face, LineKind kind, const PartFace* other) {
    if (part_of(face).kind == PlaneKind::kChimney) return;
    std::vector<PlanInterval> visible{PlanInterval{}};
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      if (static_cast<int>(p) == face.part) continue;
      if (other != nullptr && static_cast<int>(p) == other->part) continue;
      visible = subtract(visible, covered_interval(parts_[p], segment, face.height));
    }
    for (const PlanInterval& interval : visible) {
      SceneLine line{.segment = lifted(segment, interval, face.height),
                     .kind = kind,
                     .plane_ids = {face.plane_id},
                     .building_id = part_of(face).building_id};
      if (length(line.segment) < kMinRoofLineLengthM) continue;
      if (other != nullptr) line.plane_ids.push_back(other->plane_id);
      lines_.push_back(std::move(line));
    }
  }

  std::span<const RoofPart> parts_;
  std::span<const PartFace> faces_;
  std::vector<SceneLine> lines_;
};

}  // namespace

std::vector<SceneLine> roof_lines(std::span<const RoofPart> parts,
                                  std::span<const PartFace> faces) {
  return LineCollector(parts, faces).collect();
}

}  // namespace ridgeline::simulate
