// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/scene/reduced_view.h"

#include "reconstruct/geometry/check.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ridgeline::reconstruct {
namespace {

/// The mapping x -> scale x + shift of pixel coordinates.
struct PixelScale {
  double scale = 1.0;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();

  [[nodiscard]] Eigen::Vector2d operator()(const Eigen::Vector2d& x) const {
    return scale * x + shift;
  }
  [[nodiscard]] Segment2 operator()(const Segment2& s) const {
    return {(*this)(s.start), (*this)(s.end)};
  }
  [[nodiscard]] Eigen::Matrix3d homography() const {
    Eigen::Matrix3d h = Eigen::Matrix3d::Identity();
    h.topLeftCorner<2, 2>() *= scale;
    h.topRightCorner<2, 1>() = shift;
    return h;
  }
  [[nodiscard]] PixelScale inverse() const { return {1.0 / scale, -shift / scale}; }
};

/// The position in the image at which the first whole block of the frame begins.
cv::Point first_block_px(const Eigen::Vector2i& corner_px, int factor) {
  const auto skipped = [factor](int corner) {
    const int begun = (corner % factor + factor) % factor;
    return begun == 0 ? 0 : factor - begun;
  };
  return {skipped(corner_px.x()), skipped(corner_px.y())};
}

/// Maps pixels of the reduced image to pixels of the image. The centre of a block is the mean
/// position of its pixels.
PixelScale to_image_from_blocks(const cv::Point& first_px, int factor) {
  const double middle = 0.5 * (factor - 1.0);
  return {static_cast<double>(factor), {first_px.x + middle, first_px.y + middle}};
}

EdgeSegment scaled(EdgeSegment edge, const PixelScale& to) {
  edge.line.segment = to(edge.line.segment);
  edge.line.centroid_px = to(edge.line.centroid_px);
  edge.line.sigma_q_px *= to.scale;
  edge.line.sigma_e_px *= to.scale;
  edge.in_image = to(edge.in_image);
  edge.rms_px *= to.scale;
  edge.contrast /= to.scale;
  edge.scale_px *= to.scale;
  return edge;
}

}  // namespace

View reduced(const View& view, int factor) {
  check(factor >= 1, "reduced: factor = ", factor, ", must be 1 or more");
  if (factor == 1) return view;
  const cv::Point first = first_block_px(view.corner_px, factor);
  const cv::Size size(std::max(0, (view.image.cols - first.x) / factor),
                      std::max(0, (view.image.rows - first.y) / factor));
  const PixelScale to_image = to_image_from_blocks(first, factor);
  const PixelScale to_reduced = to_image.inverse();
  View small;
  small.id = view.id;
  small.corner_px = (view.corner_px + Eigen::Vector2i(first.x, first.y)) / factor;
  small.image_from_local = to_reduced.homography() * view.image_from_local;
  if (view.ideal_from_image) {
    small.ideal_from_image = [=, ideal = view.ideal_from_image](const Eigen::Vector2d& x) {
      std::optional<Eigen::Vector2d> mapped = ideal(to_image(x));
      if (mapped) mapped = to_reduced(*mapped);
      return mapped;
    };
  }
  for (const EdgeSegment& edge : view.segments) small.segments.push_back(scaled(edge, to_reduced));
  if (size.area() == 0) return small;
  const cv::Rect blocks(first, cv::Size(size.width * factor, size.height * factor));
  cv::resize(view.image(blocks), small.image, size, 0.0, 0.0, cv::INTER_AREA);
  if (!view.is_valid.empty()) {
    cv::Mat share;
    cv::Mat whole;
    cv::threshold(view.is_valid(blocks), whole, 0.0, 1.0, cv::THRESH_BINARY);
    whole.convertTo(whole, CV_32F);
    cv::resize(whole, share, size, 0.0, 0.0, cv::INTER_AREA);
    constexpr double kAll = 1.0 - 1e-3;  // block sums of ones are exact to rounding
    small.is_valid = share > kAll;
  }
  return small;
}

Eigen::Matrix3d image_from_reduced(const View& view, int factor) {
  return to_image_from_blocks(first_block_px(view.corner_px, factor), factor).homography();
}

std::vector<EdgeSegment> in_pixels_of(const View& view,
                                      int factor,
                                      std::vector<EdgeSegment> segments) {
  if (factor == 1) return segments;
  const PixelScale to_image = to_image_from_blocks(first_block_px(view.corner_px, factor), factor);
  for (EdgeSegment& edge : segments) edge = scaled(std::move(edge), to_image);
  return segments;
}

Segment2 in_pixels_of(const View& view, int factor, const Segment2& segment) {
  return to_image_from_blocks(first_block_px(view.corner_px, factor), factor)(segment);
}

int scale_of_edges(const View& view) {
  const auto sharpest = std::ranges::min_element(view.segments, {}, &EdgeSegment::scale_px);
  if (sharpest == view.segments.end()) return 1;
  return std::max(1, static_cast<int>(std::lround(sharpest->scale_px)));
}

View at_scale_of_edges(const View& view) { return reduced(view, scale_of_edges(view)); }

}  // namespace ridgeline::reconstruct
