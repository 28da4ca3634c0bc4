// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/report/report_json.h"

#include <opencv2/core/mat.hpp>

namespace ridgeline::apps {

/// The paper's figures for one patch, CV_8UC3, drawn without a browser, each with a title, a legend
/// and a scale bar.

/// Fig. 1: the segments of the base image, those aligned with the epipolar line in red.
cv::Mat figure1(const ReportPatch& patch);

/// Fig. 7: the matches in an image: correct ones in green, false ones dashed in red, missed ones in
/// yellow, those not judged (all, without reference matches) in blue. Segments without a match are
/// thin and grey.
cv::Mat figure7(const ReportPatch& patch, std::size_t image);

/// Fig. 8: the points, coloured by plane, and the lines of a method, seen from the south-west and
/// above in parallel projection. Aligned lines are red and thicker, the others blue.
cv::Mat figure8(const ReportPatch& patch, const ShownScene& scene, std::size_t method);

}  // namespace ridgeline::apps
