// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "io/project/matches_file.h"
#include "reconstruct/scene/scene.h"

#include <opencv2/core/mat.hpp>

#include <span>

namespace ridgeline::apps {

/// Both images side by side (CV_8UC3) with their segments: each match in a distinct colour on both
/// sides, every fifth labelled with the left index; unmatched segments thin and grey.
cv::Mat match_overlay(const reconstruct::View& left,
                      const reconstruct::View& right,
                      std::span<const Correspondence> matches);

}  // namespace ridgeline::apps
