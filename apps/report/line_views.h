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

/// Distance of an image segment from the projection of its line, at the end where it exceeds its
/// sigma by the larger factor.
struct Offset {
  double offset_px = 0.0;
  double sigma_px = 0.0;
};

/// Computes the distance of each end of a segment from the projected line and returns the worse
/// one. Sigma combines the contributions of the line and, if `uncertain` is given, of the segment.
/// The line was adjusted to the segment, so the true sigma is smaller, and an offset that is large
/// compared with this one is not due to chance. std::nullopt if the projection of the line has no
/// direction or the result is not finite.
///
/// @param covariance_m2  of the line's (start, end)
/// @param px             the segment, ideal pixels
std::optional<Offset> offset_of(const ProjectionMatrix& image_from_local,
                                const Segment3& line,
                                const Eigen::Matrix<double, 6, 6>& covariance_m2,
                                const Segment2& px,
                                const UncertainSegment2* uncertain);

/// A segment that is off by more than this many sigmas disagrees with its line; by chance, one end
/// in a thousand does.
inline constexpr double kMaxSigmas = 3.29;

/// How a line appears in an image.
enum class ViewOfLine : std::uint8_t {
  kAgrees,    ///< a segment lies on the projection of the line
  kDiffers,   ///< a segment is farther from the projection than its sigma allows
  kObserved,  ///< a segment whose offset is unknown, e.g. because the line has no covariance
  kMissing,   ///< no segment, although the line lies in the image and nothing hides it
  kHidden,    ///< no segment; points of the surface hide the line
  kBorder,    ///< no segment; an end of the line is outside the image or at its border
  kOutside,   ///< the line lies outside the image
  kNotUsed,   ///< no line of the method has a segment in this image
};

/// "agrees", "differs", "sighted", "missing", "hidden", "border", "outside", "not_used"
std::string_view name(ViewOfLine state);

/// Determines what an image can show, taking into account which places are hidden by points of the
/// surface.
class ImageField {
 public:
  /// @param surface_in_local  may be empty, in which case nothing is hidden
  ImageField(const ProjectionMatrix& image_from_local,
             const Eigen::Vector2d& size_px,
             std::span<const Eigen::Vector3d> surface_in_local);

  /// The state of a line that has no segment in the image: kMissing, kHidden, kBorder or kOutside.
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
  std::vector<double> nearest_m_;  ///< for each cell: distance of its nearest point from the camera
};

}  // namespace ridgeline::apps
