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

/// Metres on the ground per coordinate unit, by axis: from the CRS if it is known, else as stated
/// by the set, else 1.
Eigen::Vector3d unit_m_of(const io::LineSet& set);

/// All image segments stored with a line; those of the first two images if it has no others.
std::vector<io::LineObservation> observations_of(const io::Line& line,
                                                 const std::vector<io::PatchImage>& images);

/// A line of a file, in metres in the local frame; `unit_m`: unit_m_of() of the file.
Segment3 segment_in_local(const io::Line& line,
                          const Eigen::Vector3d& unit_m,
                          const LocalFrame& frame);

/// The lines with their coordinates in metres, without CRS and unit, which have been applied.
io::LineSet in_metres(io::LineSet set);

/// The lines of a file, in metres in the local frame. Lines without a class are classified with the
/// patch's cameras: `aligned` up to `max_aligned_angle_deg`, else `not_aligned`. Image segments
/// stored with the lines are kept as evidence.
std::vector<evaluate::JudgedLine> judged_lines_of(
    const io::LineSet& set,
    const LocalFrame& frame,
    const std::optional<io::Patch>& patch,
    double max_aligned_angle_deg = kMaxAlignedAngle_deg);

/// The lines moved by `by_m`, along with the cameras and heights of their evidence, so that their
/// image positions do not change.
std::vector<evaluate::JudgedLine> moved(std::vector<evaluate::JudgedLine> lines,
                                        const Eigen::Vector3d& by_m);

/// The lines of a file moved by `by_m`, in its coordinates.
io::LineSet moved(io::LineSet set, const Eigen::Vector3d& by_m);

/// The true lines of a file; lines with a non-finite coordinate are left out. Throws IoError if
/// none remains, or for a line that is not in_range().
std::vector<evaluate::ReferenceLine> reference_lines_of(const io::LineSet& set,
                                                        const LocalFrame& frame);

/// The figures of a line file other than its distances from LIDAR planes.
struct TruthRows {
  std::vector<evaluate::ToleranceRow> tolerances;  ///< against planes and any reference lines
  std::vector<evaluate::ReferenceRow> references;  ///< empty without reference lines
};

/// Precision and completeness of the lines that `evaluation` judged and, with reference lines,
/// their true errors.
TruthRows compare_with_truth(const evaluate::Evaluation& evaluation,
                             const std::vector<evaluate::JudgedLine>& lines,
                             const std::optional<std::vector<evaluate::ReferenceLine>>& references);

}  // namespace ridgeline::results
