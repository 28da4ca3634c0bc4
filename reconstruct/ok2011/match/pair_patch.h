// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "reconstruct/ok2011/match/constraints.h"
#include "reconstruct/views/image_sampler.h"

#include <Eigen/Core>

#include <optional>

namespace ridgeline::reconstruct {

/// Frame of a pair: x = origin + alpha first + beta second, alpha and beta in [0, 1].
struct PairFrame {
  Eigen::Vector2d origin, first, second;
};

/// Samples the parallelogram of the frame; nothing if a part of it lies outside of the image.
std::optional<PairPatch> pair_patch(const ImageSampler& image, const PairFrame& frame);

}  // namespace ridgeline::reconstruct
