// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/depth_consensus/depth_evidence.h"
#include "reconstruct/beyond/depth_consensus/depth_line.h"
#include "reconstruct/beyond/depth_consensus/flank_correlation.h"
#include "reconstruct/ok2011/estimate/candidate_points.h"
#include "reconstruct/ok2011/estimate/options.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// All that tells the depth of an aligned match.
struct DepthQuestion {
  const StereoLines& lines;
  const ObservedPair& line;
  std::span<const DepthEvidence> evidence;
  std::span<const double> heights_nearby;  ///< of the ends of other lines, conditioned frame
  const ReconstructOptions& options;
  const FlankCorrelation* flanks = nullptr;  ///< none where the images are not at hand
};

/// A line that an aligned match may show, and how likely it is before its evidence is heard.
struct DepthHypothesis {
  DepthLine line;
  double log_prior = 0.0;
};

/// How well lines explain an aligned match; see agree_on_depth().
class DepthScorer {
 public:
  explicit DepthScorer(const DepthQuestion& question);

  /// Horizontal direction of the projection plane; zero for a horizontal plane.
  [[nodiscard]] Eigen::Vector3d horizontal() const;
  /// The direction that a vector has in the projection plane.
  [[nodiscard]] Eigen::Vector3d in_plane(const Eigen::Vector3d& v) const;

  /// Within chance of the line.
  [[nodiscard]] bool supports(const DepthEvidence& evidence, const DepthLine& line) const;
  /// Largest difference of the heights of two lines over the segment.
  [[nodiscard]] double apart_m(const DepthLine& a, const DepthLine& b) const;

  /// Logarithm of the probability, up to one constant for all.
  [[nodiscard]] double score(const DepthHypothesis& hypothesis) const;

 private:
  struct Misfit {
    double distance_m, sigma_m;
  };
  [[nodiscard]] Misfit misfit(const DepthEvidence& evidence, const DepthLine& line) const;
  [[nodiscard]] double score(const DepthEvidence& evidence, const DepthLine& line) const;
  [[nodiscard]] double score_of_end(int which, const DepthLine& line) const;
  [[nodiscard]] double height(const DepthLine& line, double parameter) const;
  [[nodiscard]] double other_misclosure(const DepthLine& line) const;

  const DepthQuestion& question_;
  double unit_m_;  ///< of the conditioned frame
  Eigen::Matrix<double, 3, 6> other_from_object_;
  Eigen::Vector3d normal_;  ///< of the projection plane
};

/// Slope of a direction, positive.
double slope(const Eigen::Vector3d& direction);

}  // namespace ridgeline::reconstruct
