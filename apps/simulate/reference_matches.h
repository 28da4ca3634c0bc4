// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/physical_edges.h"
#include "apps/simulate/surface_oracle.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::simulate {

/// One physical edge as both images show it.
struct ReferenceMatch {
  std::string kind;
  Segment2 left, right;  ///< the visible part in each image, pixels of the file; one direction
};

struct ReferenceOptions {
  double step_m = 0.1;           ///< distance of the lines of sight along an edge
  double longest_gap_m = 0.5;    ///< shorter interruptions are closed
  double shortest_px = 10.0;     ///< least length of the visible part in each image
  double flank_px = 1.0;         ///< distance from an edge at which its sides are looked at
  double least_contrast = 0.03;  ///< mean difference of the sides, share of the image's range
};

/// Runs of an edge, as parameters of its segment, where one view sees it: nothing lies before it
/// and the surfaces on its two sides are not the same.
std::vector<Interval> visible_runs(const SurfaceOracle& oracle,
                                   SurfaceOracle::View view,
                                   const Segment3& edge,
                                   const ReferenceOptions& options);

/// All edges that both images show, ordered from left to right by their first point. `images`: the
/// pair as written, CV_8UC(n) or CV_16UC(n); edges without contrast in either are left out, as are
/// those that coincide with an edge of lower rank within a pixel in both images. An edge that is
/// interrupted in an image gives one match for each run that both see.
std::vector<ReferenceMatch> reference_matches(const Scene& scene,
                                              const SurfaceOracle& oracle,
                                              const std::array<cv::Mat, 2>& images,
                                              const ReferenceOptions& options = {});

/// How much of each true line each view sees: shares of its length, in order of Scene::lines.
std::vector<std::array<double, 2>> visible_shares(const Scene& scene,
                                                  const SurfaceOracle& oracle,
                                                  const ReferenceOptions& options = {});

/// The text of the file, with the columns id,kind,left_x1_px,left_y1_px,...,right_y2_px.
std::string reference_csv(std::span<const ReferenceMatch> matches);

}  // namespace ridgeline::simulate
