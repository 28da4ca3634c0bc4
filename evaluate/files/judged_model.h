// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/faces/building_table.h"
#include "evaluate/faces/face_evaluation.h"
#include "evaluate/faces/roof_face.h"
#include "evaluate/judge/options.h"
#include "evaluate/statistics/evaluation.h"
#include "io/cloud/cloud_files.h"
#include "io/lines/line_set.h"
#include "reconstruct/geometry/local_frame.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace ridgeline::results {

/// A roof of the scan that no building of a model explains.
struct MissingRoof {
  double area_m2 = 0.0;
  double explained = 0.0;  ///< share of it, in plan, over or under which the model has a building
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();  ///< local
  std::vector<std::vector<Eigen::Vector3d>> rings;   ///< see evaluate::ScanPlane; local
};

/// The judged roof faces of a model, by building; local metres.
struct JudgedModel {
  std::vector<evaluate::RoofBuilding> buildings;  ///< in the order of the model
  std::vector<std::size_t> places;                ///< indices of the buildings in LineSet::model
  std::vector<std::vector<std::size_t>> numbers;  ///< indices of their roof faces there
  std::vector<std::vector<evaluate::FaceEvaluation>> faces;  ///< of each building
  std::vector<evaluate::PointDistances> points;              ///< of each building
  std::vector<evaluate::BuildingRow> rows;                   ///< of each building
  /// See missing_roofs(); empty if the model was not compared with the edges of the scan.
  std::optional<std::vector<MissingRoof>> missing_roofs{};
};

/// Judges the roof faces of a model whose edges were judged as lines. `set`: as read, or already
/// moved according to `evaluation.shift`. The points over the faces are read again, for groups of
/// neighbouring buildings if they need more memory than `max_memory_bytes`; the results do not
/// depend on the grouping. `only`: the indices of the buildings to judge, ascending; default: all.
/// Throws IoError under the same conditions as read_cloud().
JudgedModel judge_model(io::CloudFiles& cloud,
                        const io::LineSet& set,
                        const evaluate::Evaluation& evaluation,
                        const LocalFrame& frame,
                        const evaluate::JudgeOptions& options,
                        std::uint64_t max_memory_bytes,
                        const std::optional<std::vector<std::size_t>>& only = {});

}  // namespace ridgeline::results
