// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/depth_consensus/depth_evidence.h"
#include "reconstruct/estimate/beyond/depth_consensus/surface_depth.h"
#include "reconstruct/estimate/beyond/options.h"
#include "reconstruct/estimate/ok2011/candidate_points.h"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace ridgeline::reconstruct {

/// All the information about the depth of an aligned track.
struct DepthQuestion {
  const TrackedLines& lines;
  const ObservedTrack& line;
  std::span<const DepthEvidence> evidence;
  /// Heights of the ends of other lines, conditioned frame.
  std::span<const double> heights_nearby;
  const ConsensusOptions& options;
  const BuildingOptions& building;
  const SurfaceDepth* surface = nullptr;  ///< null if the surface is not known
};

/// A hypothesis of what an aligned track shows, from its start to its end: one line or several.
struct DepthProfile {
  std::vector<DepthLine> lines;
  std::vector<std::size_t> cuts;  ///< index of the evidence at each cut, ascending along the track
  double log_prior = 0.0;
};

/// How well profiles explain an aligned track; see agree_on_depth().
class DepthScorer {
 public:
  explicit DepthScorer(const DepthQuestion& question);

  /// Horizontal direction of the projection plane; zero for a horizontal plane.
  [[nodiscard]] Eigen::Vector3d horizontal() const;
  /// The direction of a vector's projection onto the projection plane.
  [[nodiscard]] Eigen::Vector3d in_plane(const Eigen::Vector3d& v) const;
  /// The direction in the projection plane that falls as steeply as the given one rises.
  [[nodiscard]] Eigen::Vector3d mirrored(const Eigen::Vector3d& direction) const;

  /// Whether chance can explain the deviation of the evidence from the line.
  [[nodiscard]] bool supports(const DepthEvidence& evidence, const DepthLine& line) const;
  /// Whether evidence is so close to a cut that it may be on either side of it.
  [[nodiscard]] bool is_at(std::size_t cut, const DepthEvidence& evidence) const;
  /// Index of the line of a profile that is seen at a parameter of the base segment.
  [[nodiscard]] std::size_t line_at(const DepthProfile& profile, double parameter) const;

  /// Largest height difference between two profiles along the segment.
  [[nodiscard]] double apart_m(const DepthProfile& a, const DepthProfile& b) const;

  /// Height at the end of a profile above that at its start.
  [[nodiscard]] double difference_of_ends_m(const DepthProfile& profile) const;

  /// Height of the horizontal line `to` above the horizontal line `from`.
  [[nodiscard]] double rise_m(const DepthLine& from, const DepthLine& to) const {
    return unit_m_ * (to.through.z() - from.through.z());
  }

  /// Score of a profile. All scores are logarithms of probabilities, up to one constant for all.
  [[nodiscard]] double score(const DepthProfile& profile) const;
  [[nodiscard]] double score(const DepthEvidence& evidence, const DepthLine& line) const;
  /// Score of evidence so close to a cut that it can support an adjacent line but not contradict
  /// it.
  [[nodiscard]] double score_near_cut(const DepthEvidence& evidence, const DepthLine& line) const;
  /// Score of the height at an end of the track (`which`: 0 start, 1 end).
  [[nodiscard]] double score_of_end(int which, const DepthLine& line) const;
  /// Score of the evidence at the cut itself, which belongs to either line.
  [[nodiscard]] double score_of_cut(std::size_t cut,
                                    const DepthLine& before,
                                    const DepthLine& after) const;

 private:
  struct ProfileMisfit {
    double distance_m, sigma_m;
  };
  [[nodiscard]] ProfileMisfit misfit(const DepthEvidence& evidence, const DepthLine& line) const;
  [[nodiscard]] double height(const DepthLine& line, double parameter) const;
  [[nodiscard]] double other_misclosure(const DepthLine& line) const;

  const DepthQuestion& question_;
  double unit_m_;  ///< unit of length of the conditioned frame
  double reach_;   ///< reach of a cut, in parameters of the base segment
  Eigen::Matrix<double, 3, 6> other_from_object_;
  Eigen::Vector3d normal_;  ///< unit normal of the projection plane
};

/// Slope of a direction, rise over run, without sign.
double slope(const Eigen::Vector3d& direction);

}  // namespace ridgeline::reconstruct
