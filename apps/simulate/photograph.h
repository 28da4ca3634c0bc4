// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/simulate/image_window.h"
#include "apps/simulate/render.h"
#include "apps/simulate/sensor.h"

#include <opencv2/core/mat.hpp>

#include <functional>

namespace ridgeline::simulate {

/// Number of rows that photograph() passes on at a time, except for the last ones.
inline constexpr int kRowsAtOnce = 512;

/// Takes the image of a view from top to bottom and passes on its rows as they are finished,
/// CV_8UC(n) or CV_16UC(n), so that a frame of any height needs memory for kRowsAtOnce rows only.
/// Together they equal expose() of radiance(), byte-identical for any number of threads.
void photograph_rows(const Renderer& renderer,
                     const AerialView& view,
                     const SensorOptions& options,
                     const std::function<void(const cv::Mat& rows, int first_row)>& take);

/// As above, but also keeps the pixels of AerialView::village_px in memory and returns them.
ImageWindow photograph(const Renderer& renderer,
                       const AerialView& view,
                       const SensorOptions& options,
                       const std::function<void(const cv::Mat& rows)>& take);

}  // namespace ridgeline::simulate
