// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/depth_consensus/depth_evidence.h"
#include "reconstruct/beyond/depth_consensus/flank_strips.h"
#include "reconstruct/beyond/depth_consensus/strip_correlation.h"
#include "reconstruct/ok2011/estimate/candidate_points.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// What the surfaces beside an aligned match tell of its depth. Along an epipolar line the line
/// itself looks the same everywhere; the tiles, the shadows and the grass beside it do not. A depth
/// profile of the line gives each pixel of the left strip its place in the right one; where the
/// surface beside the line is as deep as the line, the strips correlate there.
///
/// A line bounds the upper one of its two surfaces. So one side s correlates along the profile, and
/// the other one, t, there too or along some profile below it, or nowhere:
///
///     S = max over s of  g(rho_s) + max(g(rho_t), max over horizontal profiles below of g(rho_t) - 3, 0)
///     g(rho) = -12 min(1, length / 30 px) log(1 - min(rho^2, 0.95)), 0 for rho <= 0
///     log_likelihood = log(0.02 + 0.98 exp(S - max S))
///
/// rho of StripCorrelation. 12 and 0.02 maximise the likelihood of the true depths of the aligned lines
/// of simulated training villages, given the strips alone; 3 gives the best lines there with all other
/// evidence (5 would be the likeliest).
class FlankCorrelation {
 public:
  /// @param line       the match, or the part of it that its mate shows
  /// @param runs_back  the right segment runs the other way than the left one
  FlankCorrelation(const StereoLines& lines,
                   const ObservedPair& line,
                   const FlankStrips& strips,
                   bool runs_back);

  /// The line of a profile at a parameter of the left segment.
  using LineAt = std::function<const DepthLine&(double parameter)>;
  /// 0 for the best profile, log(0.02) for one that explains nothing, and for all where there are no
  /// strips, or none of 20 px, or without texture, or the heights are not to be told apart.
  [[nodiscard]] double log_likelihood(const LineAt& profile) const;

  /// The lines that the strips speak for most, horizontal and sloping ones, three each at most.
  [[nodiscard]] const std::vector<DepthLine>& likely_lines() const { return likely_lines_; }

  static constexpr double kSigma_px = 0.5;  ///< of homologous() along the line
  /// A point in the left and the right image, conditioned frames.
  using Homologous = std::array<Eigen::Vector2d, 2>;
  /// Two points, near both ends, of the line close to the given one along which a side correlates best,
  /// to a fraction of a pixel. Horizontal lines are only shifted. Empty where none correlates to 0.7,
  /// or another line does clearly better.
  [[nodiscard]] std::optional<std::array<Homologous, 2>> homologous(const DepthLine& line,
                                                                    bool horizontal) const;

 private:
  /// A pixel of the left strip.
  struct Sample {
    double parameter = 0.0;  ///< along the left segment
    double share = 0.0;      ///< 0 for the first sample to 1 for the last one
    Eigen::Vector4d across;  ///< plane of its ray, across the segment
  };
  using Places = std::vector<double>;  ///< in the right strip, by sample

  std::vector<int> set_samples(const StereoLines& lines, const FlankStrip& left);
  void search_horizontal();
  void search(double most_slope);

  [[nodiscard]] Eigen::Vector3d at(const DepthLine& line, const Sample& sample) const;
  [[nodiscard]] Eigen::Vector3d at_height(const Sample& sample, double z) const;
  [[nodiscard]] double place(const Eigen::Vector3d& x) const;
  [[nodiscard]] Eigen::Vector3d seen_at(const Sample& sample, double place) const;
  [[nodiscard]] DepthLine line_through(const Places& places) const;
  [[nodiscard]] Places places_of(const LineAt& profile) const;
  [[nodiscard]] double gain(double rho) const;
  [[nodiscard]] Places raised(const Places& places, double at_start, double at_end) const;
  [[nodiscard]] std::array<double, 2> gains_below(double rise_at_start, double rise_at_end) const;
  [[nodiscard]] double score(const Places& places) const;

  /// Where a side correlates best: how much above a profile at both ends, in places.
  struct Refined {
    double rho = -1.0, start = 0.0, end = 0.0;
  };
  [[nodiscard]] Refined refined(const Places& places,
                                bool horizontal,
                                std::size_t side,
                                std::size_t slope) const;
  [[nodiscard]] Refined refined(const Places& places, bool horizontal) const;

  ObservedPair line_;
  ProjectionMatrix left_from_object_, right_from_object_;
  Segment2 right_axis_;  ///< conditioned
  int n_right_ = 0;
  std::vector<Sample> samples_;
  std::optional<StripCorrelation> strips_;
  double up_ = 1.0;  ///< sign of the step in the right strip for a line that is raised
  Places level_;     ///< of the horizontal line at the height of the patch's centre
  double lowest_ = 0.0, highest_ = 0.0;  ///< profiles that the strip shows, over that line, places
  std::array<std::vector<double>, 2> horizontal_;  ///< gain of a side along profiles, upwards
  std::array<std::vector<double>, 2> below_;       ///< the largest so far
  double gain_ = 0.0;                              ///< factor of g
  double max_score_ = 0.0;
  std::vector<DepthLine> likely_lines_;
};

}  // namespace ridgeline::reconstruct
