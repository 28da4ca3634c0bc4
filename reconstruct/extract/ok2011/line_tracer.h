// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/extract/ok2011/edge_detection.h"
#include "reconstruct/geometry/segment.h"

#include <Eigen/Core>

#include <optional>
#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// The point at which an edge crosses one row or column of pixels.
struct EdgeSample {
  Eigen::Vector2d position_px;
  double strength = 0.0;  ///< strength of the gradient across the line, 1/px
  int step = 0;           ///< the column for a flat line, the row for a steep one
};

/// The samples of a straight edge in the order of their steps, at most one per step.
using EdgeTrace = std::vector<EdgeSample>;

/// The positions of the samples.
std::vector<Eigen::Vector2d> positions(const EdgeTrace& trace);

/// Follows straight edges in a gradient image across gaps, from where they were detected to their
/// ends, and measures their exact position. An edge belongs to the first trace that claims it.
/// Longer pieces should therefore come first; later pieces of the same edge are then not traced
/// again.
class LineTracer {
 public:
  LineTracer(const GradientImage& image, const ExtractOptions& options);

  /// The edge through points that lie in order on a straight line; std::nullopt if it is already
  /// claimed or not found in the gradient image. The edge may bend slightly where it continues
  /// beyond the points.
  [[nodiscard]] std::optional<EdgeTrace> trace(std::span<const Eigen::Vector2d> points) const;

  void claim(const EdgeTrace& trace);

 private:
  struct TracedLine;

  [[nodiscard]] std::optional<EdgeSample> sample(const TracedLine& line,
                                                 int step,
                                                 double min_strength) const;
  [[nodiscard]] EdgeTrace samples_between(const TracedLine& line, int first, int last) const;
  [[nodiscard]] bool claimed(const EdgeSample& sample) const;
  void extend(EdgeTrace& trace, TracedLine& line, int direction) const;

  const GradientImage& image_;
  const ExtractOptions& options_;
  cv::Mat claimed_;  ///< CV_8UC1
};

}  // namespace ridgeline::reconstruct
