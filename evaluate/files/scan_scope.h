// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "evaluate/files/judge_files.h"
#include "evaluate/statistics/compare_with_scan.h"

#include <Eigen/Geometry>

namespace ridgeline::results {

/// Where the lines are expected to show the edges of the scan.
struct ScanArea {
  evaluate::ScanScope scope;
  Eigen::AlignedBox2d box_m;  ///< around it, local; empty if there is no such place
};

/// The stated area; otherwise that of the block; otherwise the ground that the first image of the
/// patch may show, if its size is known; otherwise the convex hull of the judged lines of all files
/// and 5 m around it. If the images of a patch are known, the scope also knows which edges at least
/// two of them show with both ends; what hides an edge is not considered.
/// @param judged  with evaluations
ScanArea scan_area(const JudgedFiles& judged, const JudgeFilesOptions& options);

}  // namespace ridgeline::results
