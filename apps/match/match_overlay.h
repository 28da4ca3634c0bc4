// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/matches_file.h"
#include "reconstruct/scene/scene.h"

#include <opencv2/core/mat.hpp>

#include <span>

namespace ridgeline::apps {

/// Both images side by side (CV_8UC3) with their segments: matched ones in a colour of their own,
/// the same on both sides, with the left index at every fifth; the others thin and grey.
cv::Mat match_overlay(const reconstruct::View& left,
                      const reconstruct::View& right,
                      std::span<const Correspondence> matches);

}  // namespace ridgeline::apps
