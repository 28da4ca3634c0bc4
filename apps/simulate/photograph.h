// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/image_window.h"
#include "apps/simulate/render.h"
#include "apps/simulate/sensor.h"

#include <opencv2/core/mat.hpp>

#include <functional>

namespace ridgeline::simulate {

/// The rows that photograph() hands over at once, but for the last ones.
inline constexpr int kRowsAtOnce = 512;

/// Takes the image of a view from top to bottom and hands over its rows as they come, CV_8UC(n) or
/// CV_16UC(n), so that a frame of any height needs the memory of kRowsAtOnce rows. Together they
/// are expose() of radiance(), the same bytes for any number of threads.
void photograph_rows(const Renderer& renderer,
                     const AerialView& view,
                     const SensorOptions& options,
                     const std::function<void(const cv::Mat& rows, int first_row)>& take);

/// The same, and returns the pixels of AerialView::village_px, which are kept in memory.
ImageWindow photograph(const Renderer& renderer,
                       const AerialView& view,
                       const SensorOptions& options,
                       const std::function<void(const cv::Mat& rows)>& take);

}  // namespace ridgeline::simulate
