// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

namespace ridgeline::evaluate {

/// Figures by number of images are given for two, three, four, and five or more.
inline constexpr int kMinImages = 2;
inline constexpr int kMaxImages = 5;

/// The group of a number of images, counted from 0; empty for fewer than two.
inline std::optional<std::size_t> image_group(std::optional<int> n_images) {
  if (n_images.value_or(0) < kMinImages) return std::nullopt;
  return static_cast<std::size_t>(std::min(*n_images, kMaxImages) - kMinImages);
}

/// `2`, `3`, `4` or `5 and more`.
inline std::string image_group_name(std::size_t group) {
  const int n_images = static_cast<int>(group) + kMinImages;
  return std::to_string(n_images) + (n_images == kMaxImages ? " and more" : "");
}
inline constexpr std::size_t kNumImageGroups = kMaxImages - kMinImages + 1;

}  // namespace ridgeline::evaluate
