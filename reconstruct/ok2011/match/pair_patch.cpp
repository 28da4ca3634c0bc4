// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/ok2011/match/pair_patch.h"

namespace ridgeline::reconstruct {

std::optional<PairPatch> pair_patch(const ImageSampler& image, const PairFrame& frame) {
  PairPatch patch;
  patch.n_bands = image.n_bands();
  int sample = 0;
  for (int row = 0; row < PairPatch::kSize; ++row) {
    const Eigen::Vector2d start = frame.origin + (row + 0.5) / PairPatch::kSize * frame.second;
    for (int column = 0; column < PairPatch::kSize; ++column) {
      const Eigen::Vector2d x = start + (column + 0.5) / PairPatch::kSize * frame.first;
      if (!image.sample(x, patch.colours[sample++])) return std::nullopt;
    }
  }
  return patch;
}

}  // namespace ridgeline::reconstruct
