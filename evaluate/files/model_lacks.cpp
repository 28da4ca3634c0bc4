// SPDX-License-Identifier: BSD-3-Clause
#include "evaluate/files/model_lacks.h"

#include "evaluate/files/judged_lines.h"
#include "reconstruct/geometry/transformed.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace ridgeline::results {
namespace {

using evaluate::PlanPolygon;

/// The share of a polygon that a model covers, by sampling: 0.5 m apart, or more if it is large.
double explained_share(const PlanPolygon& roof, const ModelPlan& plan) {
  constexpr double kStep_m = 0.5;
  constexpr double kMaxSamples = 1e4;
  const Eigen::Vector2d size_m = roof.box().sizes();
  const double step_m = std::max(kStep_m, std::sqrt(size_m.prod() / kMaxSamples));
  const int n_rows = static_cast<int>(std::ceil(size_m.y() / step_m));
  const int n_columns = static_cast<int>(std::ceil(size_m.x() / step_m));
  int n = 0, n_covered = 0;
  for (int row = 0; row < n_rows; ++row) {
    for (int column = 0; column < n_columns; ++column) {
      const Eigen::Vector2d place =
          roof.box().min() + step_m * Eigen::Vector2d(column + 0.5, row + 0.5);
      if (!roof.contains(place)) continue;
      ++n;
      n_covered += plan.covers(place) ? 1 : 0;
    }
  }
  if (n == 0) return plan.covers(roof.centroid()) ? 1.0 : 0.0;
  return static_cast<double>(n_covered) / n;
}

}  // namespace

ModelPlan::ModelPlan(const io::LineSet& set,
                     const evaluate::Evaluation& evaluation,
                     const LocalFrame& frame) {
  const Eigen::Vector3d unit_m = unit_m_of(set);
  Eigen::Vector3d by_m = Eigen::Vector3d::Zero();
  if (evaluation.shift && evaluation.shift->applied) by_m = -evaluation.shift->shift_m;
  for (const Face& face : set.model->faces) {
    if (face.kind == FaceKind::kWall || face.kind == FaceKind::kOther) continue;
    std::vector<Ring> rings = face.rings;
    for (Ring& ring : rings)
      for (Eigen::Vector3d& x : ring) x = frame.local_from_world(x.cwiseProduct(unit_m)) + by_m;
    faces_.emplace_back(rings);
    building_.push_back(face.building);
  }
  const auto boxes = transformed(faces_, [](const PlanPolygon& face) { return face.box(); });
  index_ = BoxIndex2(std::span<const Eigen::AlignedBox2d>(boxes));
}

bool ModelPlan::covers(const Eigen::Vector2d& x) const {
  const std::vector<std::size_t> near = index_.near(Eigen::AlignedBox2d(x), 0.0);
  return std::ranges::any_of(near, [&](std::size_t i) { return faces_[i].contains(x); });
}

std::optional<std::size_t> ModelPlan::nearest_building(const Eigen::Vector2d& x,
                                                       double reach_m) const {
  std::optional<std::size_t> nearest;
  double nearest_m = reach_m;
  for (const std::size_t i : index_.near(Eigen::AlignedBox2d(x), reach_m)) {
    if (faces_[i].edges().empty()) continue;
    const double distance_m = faces_[i].distance_m(x);
    const bool is_nearer = distance_m < nearest_m || (!nearest && distance_m <= nearest_m);
    if (!is_nearer) continue;
    nearest = building_[i];
    nearest_m = distance_m;
  }
  return nearest;
}

void count_missing_edges(const ModelPlan& plan,
                         const evaluate::ScanEdges& scan,
                         std::span<const Segment3> lines,
                         JudgedModel& judged) {
  constexpr double kBesideBuilding_m = 1.0;
  std::map<std::size_t, evaluate::ScanEdgeCount> counts;
  const evaluate::ScanScope everywhere{.contains = [](const Eigen::Vector2d&) { return true; }};
  for (const evaluate::ExpectedEdge& edge : evaluate::expected_edges(lines, scan, everywhere)) {
    const auto building =
        plan.nearest_building(midpoint(edge.segment).head<2>(), kBesideBuilding_m);
    if (!building) continue;
    ++counts[*building].n;
    counts[*building].n_missing += edge.is_found() ? 0 : 1;
  }
  for (std::size_t i = 0; i < judged.rows.size(); ++i)
    judged.rows[i].scan_edges = counts[judged.places[i]];
}

std::vector<MissingRoof> missing_roofs(const ModelPlan& plan,
                                       const evaluate::ScanEdges& scan,
                                       const evaluate::ScanScope& scope) {
  constexpr double kMinArea_m2 = 20.0;
  constexpr double kMinExplained = 0.5;
  std::vector<MissingRoof> missing;
  for (const evaluate::ScanPlane& plane : scan.planes) {
    const bool counts = plane.is_roof && plane.area_m2 >= kMinArea_m2 && !plane.rings.empty() &&
                        scope.contains(plane.fit.centroid.head<2>());
    if (!counts) continue;
    const double explained = explained_share(PlanPolygon(plane.rings), plan);
    if (explained >= kMinExplained) continue;
    missing.push_back({plane.area_m2, explained, plane.fit.centroid, plane.rings});
  }
  return missing;
}

}  // namespace ridgeline::results
