// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/beyond/extensions.h"
#include "reconstruct/extract/ok2011/extract_segments.h"
#include "reconstruct/scene/normalised_image.h"
#include "tests/reconstruct/extract/ok2011/blurred_scene.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

/// Makes squares of the image rough, as of grass beside asphalt, so that the blocks in which noise
/// is estimated matter.
void roughen(cv::Mat& raw) {
  constexpr int kSquare_px = 100;
  cv::RNG random(5);
  for (int y = 0; y < raw.rows; y += kSquare_px) {
    for (int x = y % (2 * kSquare_px); x < raw.cols; x += 2 * kSquare_px) {
      cv::Mat square = raw(cv::Rect(x, y, kSquare_px, kSquare_px) & cv::Rect({0, 0}, raw.size()));
      cv::Mat noise(square.size(), CV_16SC3);
      random.fill(noise, cv::RNG::NORMAL, 0.0, 14.0);
      cv::add(square, noise, square, cv::noArray(), CV_8U);
    }
  }
}

/// Segments of a window in pixels of the frame.
std::vector<Segment2> segments_in_frame(const cv::Mat& frame, const cv::Rect& window) {
  const ExtractionOptions options;
  const ImagePart part(frame(window).clone(), window.tl());
  const Eigen::Vector2d corner(window.x, window.y);
  std::vector<Segment2> segments;
  for (const EdgeSegment& edge :
       extract_segments(part, {}, options.edges, edge_refinement(options)))
    segments.push_back({edge.in_image.start + corner, edge.in_image.end + corner});
  return segments;
}

bool lies_in(const cv::Rect& area, const Segment2& segment) {
  const auto holds = [&](const Eigen::Vector2d& x) {
    return x.x() >= area.x && x.y() >= area.y && x.x() < area.br().x && x.y() < area.br().y;
  };
  return holds(segment.start) && holds(segment.end);
}

bool has_twin(const Segment2& segment, const std::vector<Segment2>& others) {
  constexpr double kSame_px = 0.02;  // a fifth of what an edge is measured to
  return std::ranges::any_of(others, [&](const Segment2& other) {
    return (segment.start - other.start).norm() < kSame_px &&
           (segment.end - other.end).norm() < kSame_px;
  });
}

TEST(FrameWindows, TwoWindowsOfAFrameHaveTheSameSegmentsInTheirCommonPart) {
  test::BlurredSceneOptions options;
  options.size_px = 900;
  cv::Mat raw = test::blurred_scene(3, options).raw;
  roughen(raw);
  const cv::Mat frame = normalised_image(raw);
  // No corner is a multiple of the blocks and tiles of the extraction.
  const cv::Rect left(0, 0, 650, 900);
  const cv::Rect right(187, 75, 713, 825);
  const std::vector<Segment2> in_left = segments_in_frame(frame, left);
  const std::vector<Segment2> in_right = segments_in_frame(frame, right);
  constexpr int kBorder_px = 100;  // blocks of noise at the border of a window are cut
  const cv::Rect common = left & right;
  const cv::Rect inner(common.x + kBorder_px, common.y + kBorder_px, common.width - 2 * kBorder_px,
                       common.height - 2 * kBorder_px);
  int n = 0;
  int n_same = 0;
  for (const Segment2& segment : in_left) {
    if (!lies_in(inner, segment)) continue;
    ++n;
    n_same += has_twin(segment, in_right);
  }
  EXPECT_GT(n, 50);
  EXPECT_GE(n_same, 0.99 * n);
}

}  // namespace
}  // namespace ridgeline::reconstruct
