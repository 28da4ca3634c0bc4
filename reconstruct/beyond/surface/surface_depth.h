// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/beyond/depth_consensus/depth_evidence.h"
#include "reconstruct/beyond/surface/surface.h"
#include "reconstruct/views/stereo_lines.h"

#include <array>
#include <functional>
#include <optional>
#include <vector>

namespace ridgeline::reconstruct {

/// What the surfaces beside a match tell of its depth: a line bounds the nearer one of the two surfaces beside it.
class SurfaceDepth {
 public:
  SurfaceDepth(const Surface& surface, const StereoLines& lines, const ObservedPair& line);

  /// The line of a profile at a parameter of the left segment.
  using LineAt = std::function<const DepthLine&(double parameter)>;
  /// 0 for a profile on the surface; log(kNonsense) for one that the surface denies. 0 where nothing is known.
  [[nodiscard]] double log_likelihood(const LineAt& profile) const;

  /// The line on the surface, and horizontal ones through each of its points.
  [[nodiscard]] std::vector<DepthLine> likely_lines(const Eigen::Vector3d& horizontal) const;

  /// A point in the left and the right image, conditioned frames, with its sigma along the line.
  struct Homologous {
    std::array<Eigen::Vector2d, 2> x;
    double sigma_px;
  };
  /// Two points of the line on the surface, if it agrees with the given one.
  [[nodiscard]] std::optional<std::array<Homologous, 2>> homologous(const DepthLine& line) const;

 private:
  /// A place along the left segment with the disparity of the nearer surface.
  struct Station {
    double parameter = 0.0;
    Eigen::Vector2d x_px;  ///< rectified
    double d_px = 0.0, sigma_px = 0.0;
    Eigen::Vector4d across;  ///< plane of its ray, across the segment
    Eigen::Vector3d point;   ///< on the surface, conditioned
  };
  [[nodiscard]] double misfit(const Station& station, const DepthLine& line) const;

  const Surface& surface_;
  const StereoLines& lines_;
  const ObservedPair& line_;
  std::vector<Station> stations_;
};

}  // namespace ridgeline::reconstruct
