// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/complete_patch.h"

#include "apps/pipeline/area_heights.h"
#include "apps/pipeline/area_views.h"
#include "io/error.h"
#include "reconstruct/geometry/transformed.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace ridgeline::apps {
namespace {

std::vector<std::string> ids_of(const std::vector<io::PatchImage>& images) {
  return transformed(images, &io::PatchImage::id);
}

void settle_heights(io::PatchFile& patch) {
  if (patch.heights == io::HeightSource::kStated) return;
  const AreaHeights heights = area_heights(patch);
  patch.height_range_m = heights.range_m;
  patch.decisions.push_back(fmt::format(
      "{}: height_range: auto is {:.1f} to {:.1f} m, the range of {} {} with a margin of {:g} m",
      patch.path, heights.range_m[0], heights.range_m[1], heights.n,
      patch.heights == io::HeightSource::kLidar ? "LIDAR points" : "cells of the surface model",
      kHeightMargin_m));
}

void warn_of_missing_files(io::PatchFile& patch) {
  constexpr std::size_t kNamed = 3;
  std::vector<std::string> names = ids_of(images_without_file(patch));
  if (names.empty()) return;
  const std::size_t n = names.size();
  names.resize(std::min(n, kNamed));
  patch.warnings.push_back(
      fmt::format("{}: {} more images of the orientation show the area but have no "
                  "file: {}{}",
                  patch.path, n, fmt::join(names, ", "), n > kNamed ? ", ..." : ""));
}

void choose_images(io::PatchFile& patch) {
  const std::size_t n = patch.images.size();
  std::vector<io::PatchImage> best = best_images(patch);
  warn_of_missing_files(patch);
  if (best.size() < 2) {
    throw io::IoError(
        patch.path, fmt::format("area: only {} of {} images show it at heights of {:.1f} to {:.1f} "
                                "m; at least two are required",
                                best.size(), n, patch.height_range_m[0], patch.height_range_m[1]));
  }
  patch.images = std::move(best);
  patch.decisions.push_back(fmt::format("{}: images of the area, {} of {}: {}", patch.path,
                                        patch.images.size(), n,
                                        fmt::join(ids_of(patch.images), ", ")));
}

/// Reads the header of an image unless its file is missing, which is said when it is needed.
void read_facts(io::PatchImage& image) {
  try {
    image.facts = io::image_facts(image.path);
  } catch (const io::MissingFileError&) {
    image.facts.reset();
  }
}

/// Turns the pixels if they fit the camera then, and not as they are stored.
void settle_turn(io::PatchFile& patch, io::PatchImage& image) {
  if (!image.facts || !image.interior || !image.interior->size_px) return;
  const Eigen::Vector2i stored(image.facts->width_px, image.facts->height_px);
  const Eigen::Vector2i frame = *image.interior->size_px;
  const bool fits_turned = swaps_axes(image.facts->turn) && frame == stored.reverse();
  if (frame == stored || !fits_turned) return;
  image.turn = image.facts->turn;
  patch.decisions.push_back(
      fmt::format("{}: rotated according to its EXIF orientation {}, because only then it matches "
                  "its camera of {} x {} pixels",
                  image.path, static_cast<int>(image.turn), frame.x(), frame.y()));
}

/// Columns and rows of a file when it has been turned; of a file that is missing those of its
/// camera. Throws IoError if nothing tells them.
Eigen::Vector2i turned_size_px(const io::PatchImage& image) {
  if (!image.facts && image.interior && image.interior->size_px) return *image.interior->size_px;
  const io::ImageFacts facts = image.facts ? *image.facts : io::image_facts(image.path);
  const Eigen::Vector2i stored(facts.width_px, facts.height_px);
  return swaps_axes(image.turn) ? Eigen::Vector2i(stored.reverse()) : stored;
}

void settle_window(io::PatchFile& patch, io::PatchImage& image) {
  if (patch.area_m.empty() || image.window) return;
  const std::optional<io::Window> window = window_of_area(patch, image, turned_size_px(image));
  if (!window) {
    throw io::IoError(
        patch.path, fmt::format("image {} does not show the area at heights of {:.1f} to {:.1f} m",
                                image.id, patch.height_range_m[0], patch.height_range_m[1]));
  }
  io::read_window_only(image, *window);
}

/// The blocks of the radiometry of a large JPEG 2000 take a good part of a minute.
bool finds_radiometry_slowly(const io::PatchImage& image) {
  constexpr double kMuch_px = 2e7;
  return image.radiometry.empty() && image.facts->format == "JP2OpenJPEG" &&
         double(image.facts->width_px) * image.facts->height_px > kMuch_px;
}

void warn_of_slow_files(io::PatchFile& patch) {
  for (const io::PatchImage& image : patch.images) {
    if (!image.window || !image.facts) continue;
    const auto slow = io::slow_reading(
        image.path, io::stored_window(*image.window, image.turn, image.facts->width_px,
                                      image.facts->height_px));
    if (slow) patch.warnings.push_back(*slow);
    if (!finds_radiometry_slowly(image)) continue;
    patch.warnings.push_back(
        fmt::format("{}: computing the radiometry of a large JPEG 2000 is slow; give it with the "
                    "key radiometry (ridgeline info {} prints it)",
                    image.path, image.path));
  }
}

}  // namespace

void complete_patch(io::PatchFile& patch) {
  settle_heights(patch);
  if (patch.chooses_images) choose_images(patch);
  for (io::PatchImage& image : patch.images) {
    read_facts(image);
    settle_turn(patch, image);
    settle_window(patch, image);
  }
  warn_of_slow_files(patch);
}

}  // namespace ridgeline::apps
