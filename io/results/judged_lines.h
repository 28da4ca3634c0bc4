// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/line_evaluation.h"
#include "evaluate/statistics/evaluation.h"
#include "evaluate/statistics/reference_errors.h"
#include "evaluate/tables/reference_table.h"
#include "evaluate/tables/tolerance_table.h"
#include "io/lines/line_set.h"
#include "io/project/patch.h"
#include "reconstruct/geometry/local_frame.h"

#include <optional>
#include <vector>

namespace ridgeline::results {

/// Metres per coordinate unit by axis, on the ground: of the CRS, else as set, else 1.
Eigen::Vector3d unit_m_of(const io::LineSet& set);

/// A line of a file in metres of the local frame; `unit_m`: of the file.
Segment3 segment_in_local(const io::Line& line,
                          const Eigen::Vector3d& unit_m,
                          const LocalFrame& frame);

/// The lines with their coordinates in metres; without CRS and unit, which have been applied.
io::LineSet in_metres(io::LineSet set);

/// The lines of a file in metres of the local frame. The patch's cameras class those without a
/// class: aligned up to `max_aligned_angle_deg`; lines that state their image segments take these along as evidence.
std::vector<evaluate::JudgedLine> judged_lines_of(
    const io::LineSet& set,
    const LocalFrame& frame,
    const std::optional<io::PatchFile>& patch,
    double max_aligned_angle_deg = kMaxAlignedAngle_deg);

/// The true lines of a file; those with coordinates that are not finite are left out. Throws IoError if none is left.
std::vector<evaluate::ReferenceLine> reference_lines_of(const io::LineSet& set,
                                                        const LocalFrame& frame);

/// Figures beside the distances from LIDAR planes.
struct TruthRows {
  std::vector<evaluate::ToleranceRow> tolerances;  ///< against planes; against lines where given
  std::vector<evaluate::ReferenceRow> references;  ///< none without reference lines
};

/// True errors of the lines that `evaluation` judged.
TruthRows compare_with_truth(const evaluate::Evaluation& evaluation,
                             const std::vector<evaluate::JudgedLine>& lines,
                             const std::optional<std::vector<evaluate::ReferenceLine>>& references);

}  // namespace ridgeline::results
