// SPDX-License-Identifier: BSD-3-Clause
#include "io/project/patch.h"

namespace ridgeline::io {

std::optional<Eigen::Vector2d> undistorted_px(const PatchImage& image,
                                              const Eigen::Vector2d& x_px) {
  if (!image.interior || image.interior->distortion.is_zero()) return x_px;
  const std::optional<Eigen::Vector2d> ideal =
      undistorted_px(*image.interior, x_px + image.window_px);
  if (!ideal) return std::nullopt;
  return *ideal - image.window_px;
}

Eigen::Vector2i turned_size_px(const PatchImage& image, const ImageFacts& facts) {
  return swaps_axes(image.turn) ? Eigen::Vector2i(facts.height_px, facts.width_px)
                                : Eigen::Vector2i(facts.width_px, facts.height_px);
}

Segment2 in_window(const Segment2& in_file, const PatchImage& image) {
  if (!image.window) return in_file;
  const Eigen::Vector2d corner(image.window->column, image.window->row);
  return {in_file.start - corner, in_file.end - corner};
}

bool is_read(const Segment2& in_window, const PatchImage& image) {
  if (!image.window) return true;
  const Eigen::Vector2d middle = midpoint(in_window);
  return middle.x() >= 0.0 && middle.y() >= 0.0 && middle.x() <= image.window->width - 1.0 &&
         middle.y() <= image.window->height - 1.0;
}

void read_window_only(PatchImage& image, const Window& window) {
  const Eigen::Vector2d corner(window.column, window.row);
  image.window = window;
  image.window_px += corner;
  image.image_from_world = window_from_world(image.image_from_world, corner);
}

std::array<double, 2> heights_in_local_m(const Patch& patch, const LocalFrame& frame) {
  return {patch.height_range_m[0] - frame.origin_m.z(),
          patch.height_range_m[1] - frame.origin_m.z()};
}

}  // namespace ridgeline::io
