// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/segment.h"
#include "reconstruct/geometry/uncertain/uncertain_segment.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace ridgeline::apps {

/// How far an image segment is from the projection of its line, at the end where this is more of
/// its sigma.
struct Offset {
  double offset_px = 0.0;
  double sigma_px = 0.0;
};

/// Distances of both ends of a segment across the projected line. Sigma has a part of the line and,
/// if `uncertain` is given, one of the segment. As the line was adjusted to the segment, the true
/// sigma is smaller, so what exceeds this one is no chance. Nothing for a line whose projection is
/// no line.
///
/// @param covariance_m2  of (start, end) of the line
/// @param px             ideal pixels
std::optional<Offset> offset_of(const ProjectionMatrix& image_from_local,
                                const Segment3& line,
                                const Eigen::Matrix<double, 6, 6>& covariance_m2,
                                const Segment2& px,
                                const UncertainSegment2* uncertain);

/// A segment off by more of its sigmas than this disagrees with its line: one end of a thousand
/// does by chance.
inline constexpr double kMaxSigmas = 3.29;

/// What an image shows of a line.
enum class ViewOfLine : std::uint8_t {
  kAgrees,    ///< a segment on the projection of the line
  kDiffers,   ///< a segment that is farther from the projection than its sigma allows
  kObserved,  ///< a segment, of a line without geometry or covariance
  kMissing,   ///< no segment, though the line lies in the image and nothing hides it
  kHidden,    ///< no segment, and points of the surface hide the line
  kBorder,    ///< no segment, and a part of the line lies outside of the image
  kOutside,   ///< the line does not lie in the image
  kNotUsed,   ///< no line of the method has a segment of this image
};

/// "agrees", "differs", "sighted", "missing", "hidden", "border", "outside", "not_used"
std::string_view name(ViewOfLine state);

/// What an image can show: it knows which places are hidden by points of the surface.
class ImageField {
 public:
  /// @param surface_in_local  may be empty: then nothing is hidden
  ImageField(const ProjectionMatrix& image_from_local,
             const Eigen::Vector2d& size_px,
             std::span<const Eigen::Vector3d> surface_in_local);

  /// What the image shows of a line of which it has no segment: kMissing, kHidden, kBorder or
  /// kOutside.
  [[nodiscard]] ViewOfLine unobserved(const Segment3& line_in_local) const;

 private:
  [[nodiscard]] bool is_inside(const Eigen::Vector2d& x_px, double border_px) const;
  [[nodiscard]] bool is_hidden(const Eigen::Vector3d& x_in_local) const;
  [[nodiscard]] std::size_t cell_of(const Eigen::Vector2d& x_px) const;

  ProjectionMatrix image_from_local_;
  Eigen::Vector3d centre_in_local_;
  Eigen::Vector2d size_px_;
  double cell_px_ = 1.0;
  std::size_t columns_ = 0;
  std::vector<double> nearest_m_;  ///< by cell: distance of its nearest point from the camera
};

}  // namespace ridgeline::apps
