// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"
#include "evaluate/statistics/cloud_following.h"
#include "evaluate/statistics/completeness.h"
#include "evaluate/statistics/constant_shift.h"
#include "evaluate/statistics/decoy_figures.h"
#include "evaluate/statistics/summary.h"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::evaluate {

/// A building of a model in an area.
struct AreaBuilding {
  std::size_t number = 0;       ///< in its file, from 0
  std::vector<std::string> by;  ///< values of the attributes by which figures are grouped
};

/// What is needed to merge the judgement of the lines of one area with those of the neighbouring
/// areas.
struct AreaPart {
  /// x_min, y_min, x_max, y_max in the cloud's coordinates; the upper bounds are exclusive.
  std::array<double, 4> bounds{};
  std::size_t n_lines = 0;           ///< in the file
  std::vector<std::size_t> numbers;  ///< in the file, from 0, of each line of the evaluation
  std::vector<JudgedDecoy> decoys;   ///< of lines of the evaluation
  std::vector<AreaBuilding> buildings;
};

/// The judged lines of one method (or tool) on one patch, with their figures.
struct Evaluation {
  std::string patch, method;
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();  ///< x_in_world = x_in_local + origin_m
  SummaryOptions options;
  std::vector<LineEvaluation> lines;  ///< every input line; planes in the local frame
  std::vector<Summary> classes;       ///< see summarize_classes()
  /// Of the lines as they were given; empty if none of them was judged.
  std::optional<ConstantShift> shift{};
  /// Of lines that were moved deliberately and judged again; empty if there are none.
  std::vector<DecoyFigure> decoys{};
  std::optional<CloudFollowing>
      elsewhere{};                 ///< of the same lines moved far away; empty if none were
  std::optional<AreaPart> area{};  ///< if only the lines of one area were judged
  /// Which edges of the scan the lines have found; empty if they were not compared.
  std::optional<Completeness> completeness{};
};

/// `evaluation` with `classes` computed from its lines and options.
Evaluation with_summaries(Evaluation evaluation);

/// The evaluations reduced to the lines, by id, that are `evaluated` in all of them: the paired
/// line set on which methods are compared. Summaries are recomputed; decoys, which refer to all
/// lines, are left out, and so is completeness. Throws std::invalid_argument if the evaluations are
/// not all of the same patch.
std::vector<Evaluation> on_common_lines(std::span<const Evaluation> evaluations);

}  // namespace ridgeline::evaluate
