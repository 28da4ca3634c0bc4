// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core/types.hpp>

namespace ridgeline::apps {

/// Okabe and Ito's colours, which colour-blind readers can distinguish; the page uses the same ones
/// (report.css, colours.ts). The channels are in OpenCV's order: blue, green, red.
namespace colour {
inline const cv::Scalar kSkyBlue(233, 180, 86);
inline const cv::Scalar kGreen(115, 158, 0);
inline const cv::Scalar kYellow(66, 228, 240);
inline const cv::Scalar kBlue(178, 114, 0);
inline const cv::Scalar kVermillion(0, 94, 213);
inline const cv::Scalar kGrey(150, 150, 150);

inline const cv::Scalar kAligned = kVermillion;
inline const cv::Scalar kNotAligned = kSkyBlue;
inline const cv::Scalar kCorrect = kGreen;
inline const cv::Scalar kFalse = kVermillion;
inline const cv::Scalar kMissed = kYellow;
}  // namespace colour

}  // namespace ridgeline::apps
