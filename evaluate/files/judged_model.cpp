// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/judged_model.h"

#include "evaluate/faces/judge_faces.h"
#include "evaluate/faces/limits.h"
#include "evaluate/files/judged_lines.h"
#include "evaluate/files/point_budget.h"
#include "reconstruct/geometry/plan_box.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

namespace ridgeline::results {
namespace {

using evaluate::RoofBuilding;

/// The faces of all buildings, with the indices of their roof faces in the model.
JudgedModel roofs_of(const io::LineSet& set, const Eigen::Vector3d& by_m, const LocalFrame& frame) {
  const io::BuildingModel& model = *set.model;
  const Eigen::Vector3d unit_m = unit_m_of(set);
  JudgedModel judged;
  judged.buildings.resize(model.buildings.size());
  judged.numbers.resize(model.buildings.size());
  judged.places.resize(model.buildings.size());
  std::iota(judged.places.begin(), judged.places.end(), std::size_t{0});
  for (std::size_t i = 0; i < model.buildings.size(); ++i)
    judged.buildings[i].id = model.buildings[i].id;
  for (std::size_t i = 0; i < model.faces.size(); ++i) {
    const Face& face = model.faces[i];
    if (face.kind == FaceKind::kOther) continue;
    std::vector<Ring> rings = face.rings;
    for (Ring& ring : rings)
      for (Eigen::Vector3d& x : ring) x = frame.local_from_world(x.cwiseProduct(unit_m)) + by_m;
    RoofBuilding& building = judged.buildings[face.building];
    evaluate::RoofFace made = evaluate::make_roof_face(
        face.id.empty() ? fmt::format("{}", i) : face.id, std::move(rings));
    if (face.kind != FaceKind::kRoof) {
      building.others.push_back(std::move(made));
      continue;
    }
    building.faces.push_back(std::move(made));
    judged.numbers[face.building].push_back(i);
  }
  return judged;
}

Eigen::AlignedBox2d plan_box(const RoofBuilding& building) {
  Eigen::AlignedBox2d box;
  for (const evaluate::RoofFace& face : building.faces)
    if (!face.degenerate) box.extend(face.plan.box());
  return box;
}

template <typename T>
std::vector<T> picked(const std::vector<std::size_t>& places, std::vector<T> all) {
  return transformed(places, [&](std::size_t i) { return std::move(all[i]); });
}

/// The buildings at these indices.
JudgedModel picked(const std::vector<std::size_t>& places, JudgedModel all) {
  return {.buildings = picked(places, std::move(all.buildings)),
          .places = places,
          .numbers = picked(places, std::move(all.numbers)),
          .faces = picked(places, std::move(all.faces)),
          .points = picked(places, std::move(all.points)),
          .rows = {}};
}

class ModelJudge {
 public:
  ModelJudge(io::CloudFiles& cloud,
             JudgedModel& judged,
             const evaluate::JudgeOptions& options,
             std::uint64_t max_points)
      : cloud_(cloud), judged_(judged), options_(options), max_points_(max_points) {
    for (const RoofBuilding& building : judged.buildings) boxes_.push_back(plan_box(building));
    judged.faces.resize(judged.buildings.size());
    judged.points.resize(judged.buildings.size());
  }

  /// Judges the buildings at these indices.
  void judge(std::vector<std::size_t> places) {
    for (const std::size_t i : places)
      if (boxes_[i].isEmpty()) judge_without_points(i);
    std::erase_if(places, [&](std::size_t i) { return boxes_[i].isEmpty(); });
    if (!places.empty()) judge_group(places);
  }

 private:
  /// Judges a group of buildings, or its halves one after the other.
  void judge_group(std::span<std::size_t> group) {
    const std::vector<std::size_t> members = with_neighbours(group);
    std::optional<io::PointCloud> near = cloud_.read_at_most(mask_of(members), max_points_);
    if (!near && group.size() > 1) {
      const std::size_t half = halve(group);
      judge_group(group.first(half));
      judge_group(group.subspan(half));
      return;
    }
    if (!near) near = cloud_.read(mask_of(members));
    const std::vector<std::uint8_t> classes = ridgeline::transformed(
        near->points, [](const io::CloudPoint& p) { return p.classification; });
    const evaluate::PointGrid grid = grid_of(*near);
    const auto buildings =
        transformed(members, [&](std::size_t i) { return judged_.buildings[i]; });
    auto faces = evaluate::judge_faces(grid, buildings, options_);
    auto points = evaluate::point_distances(grid, buildings, classes);
    for (std::size_t k = 0; k < group.size(); ++k) {
      judged_.faces[members[k]] = std::move(faces[k]);
      judged_.points[members[k]] = std::move(points[k]);
    }
  }

  void judge_without_points(std::size_t i) {
    const auto nothing =
        evaluate::PointGrid::build(0, [](std::size_t) { return Eigen::Vector3d(); });
    judged_.faces[i] = std::move(
        evaluate::judge_faces(nothing, std::span(&judged_.buildings[i], 1), options_).front());
  }

  /// The area from which points may be needed to judge these buildings.
  [[nodiscard]] io::PlanMask mask_of(const std::vector<std::size_t>& members) const {
    constexpr double kRow_m = 4.0;
    std::vector<Segment2> rows;
    for (const std::size_t i : members) {
      const Eigen::AlignedBox2d box = grown(boxes_[i], neighbour_reach_m());
      const int n_rows = static_cast<int>(box.sizes().y() / kRow_m) + 2;
      for (int row = 0; row < n_rows; ++row) {
        const double y = box.min().y() + kRow_m * row;
        rows.push_back({{box.min().x(), y}, {box.max().x(), y}});
      }
    }
    return {rows, kRow_m};
  }

  [[nodiscard]] double neighbour_reach_m() const { return 2.0 * evaluate::kFaceReach_m; }

  /// Divides a group at the median along the longer side of its bounding box; returns the size of
  /// the first half.
  std::size_t halve(std::span<std::size_t> group) const {
    Eigen::AlignedBox2d all;
    for (const std::size_t i : group) all.extend(boxes_[i].center());
    const int axis = all.sizes().x() >= all.sizes().y() ? 0 : 1;
    const std::size_t half = group.size() / 2;
    std::ranges::sort(group, {},
                      [&](std::size_t i) { return std::pair(boxes_[i].center()[axis], i); });
    return half;
  }

  /// The group, followed by the buildings whose planes its faces need: those within reach, and
  /// those within reach of these, because a plane depends on the planes around it.
  [[nodiscard]] std::vector<std::size_t> with_neighbours(std::span<const std::size_t> group) const {
    std::vector<std::size_t> members(group.begin(), group.end());
    std::vector<bool> is_in(boxes_.size(), false);
    for (const std::size_t i : group) is_in[i] = true;
    for (int ring = 0; ring < 2; ++ring) {
      Eigen::AlignedBox2d all;
      for (const std::size_t i : members) all.extend(grown(boxes_[i], neighbour_reach_m()));
      for (std::size_t i = 0; i < boxes_.size(); ++i) {
        if (is_in[i] || boxes_[i].isEmpty() || !all.intersects(boxes_[i])) continue;
        is_in[i] = true;
        members.push_back(i);
      }
    }
    return members;
  }

  io::CloudFiles& cloud_;
  JudgedModel& judged_;
  const evaluate::JudgeOptions& options_;
  std::uint64_t max_points_;
  std::vector<Eigen::AlignedBox2d> boxes_;  ///< of the buildings in plan
};

}  // namespace

JudgedModel judge_model(io::CloudFiles& cloud,
                        const io::LineSet& set,
                        const evaluate::Evaluation& evaluation,
                        const LocalFrame& frame,
                        const evaluate::JudgeOptions& options,
                        std::uint64_t max_memory_bytes,
                        const std::optional<std::vector<std::size_t>>& only) {
  const bool is_moved = evaluation.shift && evaluation.shift->applied;
  const Eigen::Vector3d by_m =
      is_moved ? Eigen::Vector3d(-evaluation.shift->shift_m) : Eigen::Vector3d::Zero();
  JudgedModel judged = roofs_of(set, by_m, frame);
  ModelJudge(cloud, judged, options, max_memory_bytes / kBytesPerPoint)
      .judge(only.value_or(judged.places));
  if (only) judged = picked(*only, std::move(judged));
  judged.rows =
      evaluate::building_table(judged.buildings, judged.faces, judged.points, evaluation.lines);
  return judged;
}

}  // namespace ridgeline::results
