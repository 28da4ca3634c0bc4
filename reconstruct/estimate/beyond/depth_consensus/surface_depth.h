// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/estimate/beyond/depth_consensus/depth_evidence.h"
#include "reconstruct/estimate/tracked_lines.h"
#include "reconstruct/surface/side_planes.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// The depth of a track from the surfaces beside it. Along an epipolar line, the line itself looks
/// the same everywhere. Dense matching gives the depth of the surfaces on both sides of it
/// (side_plane()), and a line bounds the nearer one.
///
/// For every 30 px of the left segment (sides_along()), the line's disparity on the nearer surface
/// is known with a sigma. A surface that explains less than half of its strip is not used. With the
/// mean square z^2 of a profile's misfits in these sigmas:
///
///     log_likelihood = log(0.015 + 0.985 exp(-z^2 / 2))
///
/// In the training scenes, true roof edges are more than 3 sigma off with a frequency of 0.015. A
/// wrong surface, for example in deep shadow, therefore costs a profile no more than that.
class SurfaceDepth {
 public:
  /// @param line  the track, or the part of it that its counterpart shows
  /// All arguments must live as long as the result.
  SurfaceDepth(const Surface& surface, const TrackedLines& lines, const ObservedTrack& line);

  /// The line of a profile at a parameter of the left segment.
  using LineAt = std::function<const DepthLine&(double parameter)>;
  /// 0 for a profile on the surface, log(0.015) for one that the surface contradicts; 0 for all if
  /// no surface is known.
  [[nodiscard]] double log_likelihood(const LineAt& profile) const;

  /// The line on the surface, and horizontal lines through each of its known points.
  /// @param horizontal  direction of a horizontal line in the projection plane; zero if there is
  /// none
  [[nodiscard]] std::vector<DepthLine> likely_lines(const Eigen::Vector3d& horizontal) const;

  /// A point in the left and the right image, conditioned frames, with its sigma along the line.
  struct Homologous {
    std::array<Eigen::Vector2d, 2> x;
    double sigma_px;
  };
  /// Two points on the surface, near both ends of the segment. Empty if the surface is known at
  /// fewer than two stations, or if the given line is more than 3 sigma (RMS) off them.
  [[nodiscard]] std::optional<std::array<Homologous, 2>> homologous(const DepthLine& line) const;

 private:
  /// A position along the left segment with the disparity of the nearer surface.
  struct Station {
    double parameter = 0.0;
    double d_px = 0.0, sigma_px = 0.0;
    Eigen::Vector4d across;  ///< plane through its ray, perpendicular to the segment in the image
    Eigen::Vector3d point;   ///< its point on the surface, conditioned
  };
  void add_stations(const SidesOfPiece& piece);
  void add_station(double parameter, double d_px, double sigma_px);
  [[nodiscard]] Eigen::Vector2d rectified(const Eigen::Vector2d& x_in_left) const;
  [[nodiscard]] double misfit(const Station& station, const DepthLine& line) const;
  [[nodiscard]] std::array<Eigen::Vector2d, 2> seen(double parameter, double d_px) const;

  const Surface& surface_;
  const TrackedLines& lines_;
  const ObservedTrack& line_;
  std::vector<Station> stations_;
};

}  // namespace ridgeline::reconstruct
