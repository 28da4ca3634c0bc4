// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "apps/report/report_json.h"

#include <opencv2/core/mat.hpp>

namespace ridgeline::apps {

/// The figures of the paper for one patch, CV_8UC3, drawn without a browser, each with title,
/// legend and scale bar.

/// Fig. 1: the segments of the base image, those aligned with the epipolar line in red.
cv::Mat figure1(const ReportPatch& patch);

/// Fig. 7: the matches in an image: correct green, false red and dashed, missed yellow; without
/// reference matches all of them blue. Segments without a match thin and grey.
cv::Mat figure7(const ReportPatch& patch, std::size_t image);

/// Fig. 8: the points coloured by plane and the lines of a method from the south-west and above, in
/// parallel projection: aligned lines red and thicker, others blue.
cv::Mat figure8(const ReportPatch& patch, const ShownScene& scene, std::size_t method);

}  // namespace ridgeline::apps
