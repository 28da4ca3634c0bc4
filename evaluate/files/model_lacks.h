// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/plan_polygon.h"
#include "evaluate/files/judged_model.h"
#include "evaluate/scan/scan_edges.h"
#include "evaluate/statistics/compare_with_scan.h"
#include "io/lines/line_set.h"
#include "reconstruct/geometry/box_index.h"
#include "reconstruct/geometry/local_frame.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ridgeline::results {

/// The roofs and floors of all buildings of a model in plan.
class ModelPlan {
 public:
  /// `set`: with a model. `evaluation`: of its lines, whose shift the buildings take if it was
  /// applied.
  ModelPlan(const io::LineSet& set,
            const evaluate::Evaluation& evaluation,
            const LocalFrame& frame);

  [[nodiscard]] bool covers(const Eigen::Vector2d& x) const;
  /// The building nearest to a place, at most `reach_m` away; the first of several.
  [[nodiscard]] std::optional<std::size_t> nearest_building(const Eigen::Vector2d& x,
                                                            double reach_m) const;

 private:
  std::vector<evaluate::PlanPolygon> faces_;
  std::vector<std::size_t> building_;  ///< of each face, by its number in the model
  BoxIndex2 index_;
};

/// Fills in BuildingRow::scan_edges: the edges of the scan that count, see
/// evaluate::compare_with_scan(), with their middle on the building in plan or at most 1 m away and
/// nearer to no other one. `lines`: the edges of the model.
void count_missing_edges(const ModelPlan& plan,
                         const evaluate::ScanEdges& scan,
                         std::span<const Segment3> lines,
                         JudgedModel& judged);

/// The roof planes of 20 m2 and more in the scope of which less than half lies on buildings in
/// plan, in the order of the scan.
std::vector<MissingRoof> missing_roofs(const ModelPlan& plan,
                                       const evaluate::ScanEdges& scan,
                                       const evaluate::ScanScope& scope);

}  // namespace ridgeline::results
