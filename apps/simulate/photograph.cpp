// SPDX-License-Identifier: BSD-3-Clause
#include "apps/simulate/photograph.h"

#include <algorithm>

namespace ridgeline::simulate {
namespace {

/// Copies the part of some image rows that lies in a window.
void copy_rows(const cv::Mat& rows, int first_row, ImageWindow& window) {
  const int begin = std::max(first_row, window.corner_px.y());
  const int end = std::min(first_row + rows.rows, window.corner_px.y() + window.pixels.rows);
  if (begin >= end) return;
  const cv::Range columns(window.corner_px.x(), window.corner_px.x() + window.pixels.cols);
  cv::Mat target = window.pixels.rowRange(begin - window.corner_px.y(), end - window.corner_px.y());
  rows(cv::Range(begin - first_row, end - first_row), columns).copyTo(target);
}

}  // namespace

void photograph_rows(const Renderer& renderer,
                     const AerialView& view,
                     const SensorOptions& options,
                     const std::function<void(const cv::Mat& rows, int first_row)>& take) {
  const int around = rows_around(options);
  for (int first = 0; first < view.size_px.y(); first += kRowsAtOnce) {
    const int end = std::min(first + kRowsAtOnce, view.size_px.y());
    const int first_seen = std::max(first - around, 0);
    const int end_seen = std::min(end + around, view.size_px.y());
    const cv::Mat image =
        expose(renderer.radiance(view, first_seen, end_seen), options, view.number, first_seen);
    take(image.rowRange(first - first_seen, end - first_seen), first);
  }
}

ImageWindow photograph(const Renderer& renderer,
                       const AerialView& view,
                       const SensorOptions& options,
                       const std::function<void(const cv::Mat& rows)>& take) {
  ImageWindow village;
  photograph_rows(renderer, view, options, [&](const cv::Mat& rows, int first_row) {
    if (first_row == 0 && !view.village_px.isEmpty()) {
      const Eigen::Vector2i size = view.village_px.sizes() + Eigen::Vector2i::Ones();
      village = {cv::Mat(size.y(), size.x(), rows.type()), view.village_px.min()};
    }
    copy_rows(rows, first_row, village);
    take(rows);
  });
  return village;
}

}  // namespace ridgeline::simulate
