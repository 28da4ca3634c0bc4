// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/image_window.h"
#include "apps/simulate/visible_runs.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ridgeline::simulate {

/// A visible run of an edge in one view.
struct VisibleRun {
  std::size_t view = 0;
  PlanInterval run;     ///< parameters of the edge's segment
  Segment2 segment_px;  ///< its image, pixels of the file; one direction for all runs of an edge
  double visible_share = 0.0;  ///< share of the edge that the view sees, all runs together
  double contrast = 0.0;       ///< contrast_across() in the image; measure_contrast() sets it
};

/// A physical edge with its appearance in the views.
struct ShownEdge {
  std::string kind;
  int rank = 0;                  ///< as PhysicalEdge::rank
  std::vector<VisibleRun> runs;  ///< by view, then along the edge

  [[nodiscard]] std::vector<VisibleRun> in_view(std::size_t view) const;
};

/// All physical edges of a scene with their visible runs in the views, determined from the surfaces
/// only, regardless of contrast.
std::vector<ShownEdge> shown_edges(const SyntheticScene& scene, const SurfaceOracle& oracle);

/// Measures the contrast of all runs in a view. `village`: the part of its image that shows the
/// village.
void measure_contrast(std::size_t view, const ImageWindow& village, std::span<ShownEdge> edges);

/// Whether a run is long enough and has enough contrast.
bool is_clear(const VisibleRun& run);

/// Removes the edges that coincide in all their runs, within a pixel, with an edge of lower rank or
/// a longer one of equal rank. The result is ordered by the first view that shows an edge and,
/// within the view, from left to right by its first point.
std::vector<ShownEdge> without_duplicates(std::vector<ShownEdge> edges);

}  // namespace ridgeline::simulate
