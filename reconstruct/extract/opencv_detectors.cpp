// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/opencv_detectors.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc/edge_drawing.hpp>

namespace ridgeline::reconstruct {
namespace {

cv::Mat grey_image(const cv::Mat& image) {
  cv::Mat mean;
  const cv::Mat weights(1, image.channels(), CV_32F, cv::Scalar(1.0 / image.channels()));
  cv::transform(image, mean, weights);
  cv::Mat grey;
  mean.convertTo(grey, CV_8U, 255.0);
  return grey;
}

std::vector<cv::Vec4f> lsd_lines(const cv::Mat& grey) {
  constexpr float kShift_px = 0.125F;
  std::vector<cv::Vec4f> lines;
  cv::createLineSegmentDetector(cv::LSD_REFINE_STD, 0.8)->detect(grey, lines);
  for (cv::Vec4f& line : lines) line += cv::Vec4f::all(kShift_px);
  return lines;
}

std::vector<cv::Vec4f> edge_drawing_lines(const cv::Mat& grey, double min_length_px) {
  const auto detector = cv::ximgproc::createEdgeDrawing();
  detector->params.MinLineLength = static_cast<int>(min_length_px);
  std::vector<cv::Vec4f> lines;
  detector->detectEdges(grey);
  detector->detectLines(lines);
  return lines;
}

}  // namespace

std::vector<Segment2> opencv_segments(const cv::Mat& image, const ExtractOptions& options) {
  const cv::Mat grey = grey_image(image);
  // its smoothing and its search around a pixel need some pixels
  constexpr int kSmallest_px = 16;
  if (grey.rows < kSmallest_px || grey.cols < kSmallest_px) return {};
  const std::vector<cv::Vec4f> lines = options.detector == Detector::kLsd
                                           ? lsd_lines(grey)
                                           : edge_drawing_lines(grey, options.min_length_px);
  std::vector<Segment2> segments;
  for (const cv::Vec4f& line : lines) {
    const Segment2 segment{{line[0], line[1]}, {line[2], line[3]}};
    if (length(segment) >= options.min_length_px) segments.push_back(segment);
  }
  return segments;
}

}  // namespace ridgeline::reconstruct
