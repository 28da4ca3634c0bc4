// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/geometry/edge_segment.h"
#include "reconstruct/geometry/epipolar.h"
#include "reconstruct/geometry/epipolar_transfer.h"
#include "reconstruct/geometry/local_frame.h"
#include "reconstruct/geometry/track.h"

#include <opencv2/core/mat.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ridgeline::reconstruct {

/// An oriented image.
struct View {
  std::string id;
  ProjectionMatrix image_from_local;  ///< ideal pixel; (0, 0) is the centre of the top-left pixel
  cv::Mat image;                ///< 8 or 16 bits with 1 to 4 bands, or the result of normalised()
  PixelMap ideal_from_image{};  ///< removes the lens distortion; empty if there is none
  std::vector<EdgeSegment> segments{};  ///< result of extract()
  cv::Mat is_valid{};  ///< CV_8UC1, 0 where the image has no data; empty if it has data everywhere
  /// Top-left corner of the image in the frame from which it is cut.
  Eigen::Vector2i corner_px = Eigen::Vector2i::Zero();
  /// Segments found by another detector, which extract() uses instead of detecting edges. Only
  /// `in_image`, the sigmas of `line`, and `scale_px` are set.
  std::optional<std::vector<EdgeSegment>> own_segments{};
};

/// Oriented images of one place.
struct Scene {
  std::vector<View> views;
  std::array<double, 2> height_range_in_local_m{};  ///< lowest and highest height of objects
  LocalFrame frame{};  ///< by default, local coordinates equal world coordinates
};

/// A pair of views ready to be matched, with images from normalised(). It does not own the views.
struct StereoPair {
  std::array<const View*, 2> views{};  ///< left (base), right
  std::array<double, 2> height_range_in_local_m{};

  [[nodiscard]] std::array<ProjectionMatrix, 2> cameras() const {
    return {views[0]->image_from_local, views[1]->image_from_local};
  }
};

/// A pair of views with the transfer of points between them.
struct SearchedPair {
  const View& left;
  const View& right;
  StereoSearch search;
};

/// The local frame for a base view. Its origin is the point at the mean height that is seen at the
/// middle of the view, rounded to 100 m.
LocalFrame local_frame(const ProjectionMatrix& image_from_world,
                       const Eigen::Vector2d& size_px,
                       const std::array<double, 2>& height_range_m);

/// The scene in the local frame of its first view.
Scene in_local_frame(Scene scene);

/// The view's image as used by all stages: CV_32F, 0 dark .. 1 bright.
cv::Mat normalised(const View& view);

/// Two views of the scene as a pair, which does not own them.
StereoPair stereo_pair(const Scene& scene, const ViewPair& views);

/// The pair with its transfer. Throws std::invalid_argument under the same conditions as
/// StereoSearch, and unless both images are CV_32F with 1 to 4 bands, the same number of bands, and
/// at least 2 x 2 pixels.
SearchedPair searched(const StereoPair& pair);

/// The segments of a view in ideal pixels.
std::vector<Segment2> ideal_segments(const View& view);

}  // namespace ridgeline::reconstruct
