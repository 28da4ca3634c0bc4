// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/appearance/flanks.h"

#include <utility>

namespace ridgeline::reconstruct {
namespace {

constexpr double kNearest_px = 1.5;  ///< centre of the first pixel of the strip, which starts at 1
constexpr int kNumSamplesAcross = 5;

/// Sum of the values of nearest pixels.
struct ColourSum {
  std::array<double, 4> sum{};
  int n = 0;

  void add(const cv::Mat& image, const Eigen::Vector2d& x_px) {
    const long x = std::lround(x_px.x());
    const long y = std::lround(x_px.y());
    if (x < 0 || y < 0 || x >= image.cols || y >= image.rows) return;
    const auto* pixel = image.ptr<float>(static_cast<int>(y)) + x * image.channels();
    for (int band = 0; band < image.channels(); ++band) sum[band] += pixel[band];
    ++n;
  }

  [[nodiscard]] Flank mean(int n_bands) const {
    Flank flank;
    if (n == 0) return flank;
    double grey = 0.0;
    for (int band = 0; band < n_bands; ++band) {
      flank.colour[band] = static_cast<float>(sum[band] / n);
      grey += sum[band] / n;
    }
    flank.grey = static_cast<float>(grey / n_bands);
    return flank;
  }
};

}  // namespace

std::array<Flank, 2> flanks(const cv::Mat& image, const Segment2& in_image, double scale_px) {
  const Eigen::Vector2d u = along(in_image);
  const Eigen::Vector2d n = normal_of(u);
  std::array<ColourSum, 2> sums;
  const int n_along = static_cast<int>(length(in_image)) + 1;
  for (int i = 0; i < n_along; ++i) {
    const Eigen::Vector2d on_line = in_image.start + double(i) * u;
    for (int k = 0; k < kNumSamplesAcross; ++k) {
      const double distance = scale_px * (kNearest_px + k);
      sums[0].add(image, on_line - distance * n);
      sums[1].add(image, on_line + distance * n);
    }
  }
  return {sums[0].mean(image.channels()), sums[1].mean(image.channels())};
}

void set_flanks(const cv::Mat& image, EdgeSegment& segment) {
  const auto [left, right] = flanks(image, segment.in_image, segment.scale_px);
  segment.left = left;
  segment.right = right;
  if (left.grey <= right.grey) return;
  std::swap(segment.left, segment.right);
  for (Segment2* line : {&segment.in_image, &segment.line.segment})
    std::swap(line->start, line->end);
}

}  // namespace ridgeline::reconstruct
