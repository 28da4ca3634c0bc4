// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/decide_patch.h"

#include "apps/pipeline/area_heights.h"
#include "apps/pipeline/area_views.h"
#include "io/error.h"
#include "reconstruct/geometry/transformed.h"
#include "reconstruct/scene/scene.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace ridgeline::apps {
namespace {

using Texts = std::vector<std::string>;

Texts ids_of(const std::vector<io::PatchImage>& images) {
  return transformed(images, &io::PatchImage::id);
}

/// The heights stated in the file; else those of the area, with a decision that reports them.
std::array<double, 2> decided_heights_m(const io::PatchFile& file, io::Patch& patch) {
  if (file.height_range_m) return *file.height_range_m;
  const std::vector<double> heights_m = area_heights_m(file, patch.warnings);
  const auto range_m = height_range_m(heights_m);
  patch.decisions.push_back(fmt::format(
      "{}: height_range: auto is {:.1f} to {:.1f} m, the range of {} {} with a margin of {:g} m",
      file.path, range_m[0], range_m[1], heights_m.size(),
      file.surface_model ? "cells of the surface model" : "LIDAR points", kHeightMargin_m));
  return range_m;
}

/// Selects the images of a file with candidates and adds a decision that names them.
std::vector<io::PatchImage> chosen_images(const io::PatchFile& file,
                                          const SearchedPlace& place,
                                          Texts& decisions) {
  std::vector<io::PatchImage> best = best_images(file.images, *file.max_views, place);
  const std::size_t n = file.images.size();
  if (best.size() < 2) {
    throw io::IoError(
        file.path, fmt::format("area: only {} of {} images show it at heights of {:.1f} to {:.1f} "
                               "m; at least two are required",
                               best.size(), n, place.height_range_m[0], place.height_range_m[1]));
  }
  decisions.push_back(fmt::format("{}: images of the area, {} of {}: {}", file.path, best.size(), n,
                                  fmt::join(ids_of(best), ", ")));
  return best;
}

/// Warns about candidates that show the area but have no file.
void warn_of_missing_files(const io::PatchFile& file, const SearchedPlace& place, Texts& warnings) {
  constexpr std::size_t kNamed = 3;
  Texts names = ids_of(images_that_show(place, file.without_file));
  if (names.empty()) return;
  const std::size_t n = names.size();
  names.resize(std::min(n, kNamed));
  warnings.push_back(
      fmt::format("{}: {} more images of the orientation show the area but have no "
                  "file: {}{}",
                  file.path, n, fmt::join(names, ", "), n > kNamed ? ", ..." : ""));
}

/// Reads the header of an image. A missing file is only reported when it is needed.
void read_facts(io::PatchImage& image) {
  try {
    image.facts = io::image_facts(image.path);
  } catch (const io::MissingFileError&) {
    image.facts.reset();
  }
}

/// Turns the pixels if they fit the camera after turning but not as stored.
void settle_turn(io::PatchImage& image, Texts& decisions) {
  if (!image.facts || !image.interior || !image.interior->size_px) return;
  const Eigen::Vector2i stored(image.facts->width_px, image.facts->height_px);
  const Eigen::Vector2i frame = *image.interior->size_px;
  const bool fits_turned = swaps_axes(image.facts->turn) && frame == stored.reverse();
  if (frame == stored || !fits_turned) return;
  image.turn = image.facts->turn;
  decisions.push_back(
      fmt::format("{}: rotated according to its EXIF orientation {}, because only then it matches "
                  "its camera of {} x {} pixels",
                  image.path, static_cast<int>(image.turn), frame.x(), frame.y()));
}

/// Columns and rows of a file after turning; for a missing file, those of its camera. Throws
/// IoError if they are unknown.
Eigen::Vector2i size_px_of_file(const io::PatchImage& image) {
  if (!image.facts && image.interior && image.interior->size_px) return *image.interior->size_px;
  return turned_size_px(image, image.facts ? *image.facts : io::image_facts(image.path));
}

void settle_window(const SearchedPlace& place, const std::string& path, io::PatchImage& image) {
  if (place.area_m.empty() || image.window) return;
  const std::optional<io::Window> window = window_of_area(place, image, size_px_of_file(image));
  if (!window) {
    throw io::IoError(
        path, fmt::format("image {} does not show the area at heights of {:.1f} to {:.1f} m",
                          image.id, place.height_range_m[0], place.height_range_m[1]));
  }
  io::read_window_only(image, *window);
}

LocalFrame frame_of(const io::PatchImage& base, const std::array<double, 2>& height_range_m) {
  Eigen::Vector2i size_px = Eigen::Vector2i::Zero();
  if (base.window) {
    size_px = {base.window->width, base.window->height};
  } else if (base.facts || (base.interior && base.interior->size_px)) {
    size_px = size_px_of_file(base);
  }
  return reconstruct::local_frame(base.image_from_world, size_px.cast<double>(), height_range_m);
}

/// Decoding the blocks for the radiometry of a large JPEG 2000 file takes a large part of a minute.
bool finds_radiometry_slowly(const io::PatchImage& image) {
  constexpr double kMuch_px = 2e7;
  return image.radiometry.empty() && image.facts->format == "JP2OpenJPEG" &&
         double(image.facts->width_px) * image.facts->height_px > kMuch_px;
}

void warn_of_slow_files(const std::vector<io::PatchImage>& images, Texts& warnings) {
  for (const io::PatchImage& image : images) {
    if (!image.window || !image.facts) continue;
    const auto slow = io::slow_reading(
        image.path, io::stored_window(*image.window, image.turn, image.facts->width_px,
                                      image.facts->height_px));
    if (slow) warnings.push_back(*slow);
    if (!finds_radiometry_slowly(image)) continue;
    warnings.push_back(
        fmt::format("{}: computing the radiometry of a large JPEG 2000 is slow; give it with the "
                    "key radiometry (ridgeline info {} prints it)",
                    image.path, image.path));
  }
}

}  // namespace

io::Patch decide_patch(const io::PatchFile& file) {
  io::Patch patch{static_cast<const io::Project&>(file)};
  patch.reference_matches = file.reference_matches;
  patch.reference_tracks = file.reference_tracks;
  patch.height_range_m = decided_heights_m(file, patch);
  const SearchedPlace place{file.area_m, patch.height_range_m};
  if (file.max_views) {
    patch.images = chosen_images(file, place, patch.decisions);
    patch.images_are_chosen = true;
    warn_of_missing_files(file, place, patch.warnings);
  }
  for (io::PatchImage& image : patch.images) {
    read_facts(image);
    settle_turn(image, patch.decisions);
    settle_window(place, patch.path, image);
  }
  warn_of_slow_files(patch.images, patch.warnings);
  patch.frame = frame_of(patch.images.front(), patch.height_range_m);
  return patch;
}

}  // namespace ridgeline::apps
