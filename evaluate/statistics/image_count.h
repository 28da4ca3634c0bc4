// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

namespace ridgeline::evaluate {

/// Figures by number of images are of two, three, four, and of five and more.
inline constexpr int kFewestImages = 2;
inline constexpr int kMostImages = 5;

/// The group of a number of images, from 0; empty for fewer than two.
inline std::optional<std::size_t> image_group(std::optional<int> n_images) {
  if (n_images.value_or(0) < kFewestImages) return std::nullopt;
  return static_cast<std::size_t>(std::min(*n_images, kMostImages) - kFewestImages);
}

/// `2`, `3`, `4` or `5 and more`.
inline std::string image_group_name(std::size_t group) {
  const int n_images = static_cast<int>(group) + kFewestImages;
  return std::to_string(n_images) + (n_images == kMostImages ? " and more" : "");
}
inline constexpr std::size_t kNumImageGroups = kMostImages - kFewestImages + 1;

}  // namespace ridgeline::evaluate
