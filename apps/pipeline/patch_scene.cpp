// SPDX-License-Identifier: BSD-3-Clause
#include "apps/pipeline/patch_scene.h"

#include "apps/pipeline/black_border.h"
#include "io/images/image.h"
#include "io/project/segments_file.h"
#include "reconstruct/scene/normalised_image.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <functional>
#include <future>
#include <optional>
#include <utility>

namespace ridgeline::apps {
namespace {

/// The map that removes lens distortion; empty without distortion. The view must outlive it.
PixelMap ideal_from_image(const io::PatchImage& view) {
  if (!view.interior || view.interior->distortion.is_zero()) return {};
  return [&view](const Eigen::Vector2d& x_px) { return io::undistorted_px(view, x_px); };
}

/// The segments from the image's own segment file, in pixels of the part read.
std::vector<EdgeSegment> own_segments(const io::PatchImage& image) {
  std::vector<EdgeSegment> segments;
  for (EdgeSegment segment : io::read_own_segments(*image.segments, image.segment_sigma_px)) {
    segment.in_image = in_window(segment.in_image, image);
    if (is_read(segment.in_image, image)) segments.push_back(segment);
  }
  return segments;
}

std::optional<std::string> unused_segments(const io::PatchImage& image,
                                           const reconstruct::View& view) {
  if (!image.segments) return std::nullopt;
  const std::size_t n = io::read_own_segments(*image.segments, image.segment_sigma_px).size();
  const std::size_t n_used = extracted(view.segments).size();
  if (n_used == n) return std::nullopt;
  return fmt::format(
      "{}: {} of {} segments are ignored: they lie outside the window, next to pixels without "
      "data, or where the lens distortion is unknown; ids of results count the remaining ones",
      *image.segments, n - n_used, n);
}

}  // namespace

PatchPicture read_image(const io::PatchImage& image, double max_mpx) {
  const io::Picture picture =
      io::read_picture(image.path, {image.window, image.turn, image.radiometry.empty(), max_mpx});
  const reconstruct::BandRanges ranges =
      image.radiometry.empty() ? reconstruct::band_ranges(picture.sample) : image.radiometry;
  return {reconstruct::stretched_image(picture.pixels, ranges), picture.is_valid};
}

std::vector<PatchPicture> patch_images(const io::Patch& patch, double max_mpx) {
  std::vector<std::future<PatchPicture>> readers;
  for (const io::PatchImage& image : patch.images)
    readers.push_back(std::async(std::launch::async, read_image, std::cref(image), max_mpx));
  std::vector<PatchPicture> images;
  images.reserve(readers.size());
  for (std::future<PatchPicture>& reader : readers) images.push_back(reader.get());
  return images;
}

reconstruct::View view_of(const io::PatchImage& image, const LocalFrame& frame) {
  reconstruct::View view;
  view.id = image.id;
  view.image_from_local = image_from_local(image.image_from_world, frame.origin_m);
  view.ideal_from_image = ideal_from_image(image);
  view.corner_px = image.window_px.array().round().cast<int>();
  return view;
}

reconstruct::Scene patch_scene(const io::Patch& patch, const std::vector<PatchPicture>& images) {
  reconstruct::Scene scene{{}, io::heights_in_local_m(patch, patch.frame), patch.frame};
  for (const io::PatchImage& image : patch.images)
    scene.views.push_back(view_of(image, patch.frame));
  for (std::size_t i = 0; i < images.size(); ++i) {
    scene.views[i].image = images[i].image;
    scene.views[i].is_valid = images[i].is_valid;
    const io::PatchImage& image = patch.images[i];
    if (image.segments) scene.views[i].own_segments = own_segments(image);
  }
  return scene;
}

std::vector<std::string> image_warnings(const io::Patch& patch, const reconstruct::Scene& scene) {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < patch.images.size(); ++i) {
    const reconstruct::View& view = scene.views[i];
    for (std::optional<std::string>& warning :
         std::array{black_border(patch.images[i].path, view.image, view.is_valid),
                    unused_segments(patch.images[i], view)}) {
      if (warning) warnings.push_back(std::move(*warning));
    }
  }
  return warnings;
}

std::string edges_file(const io::PatchImage& image) {
  return fmt::format("edges.{}.csv", image.id);
}

std::string segments_file(const io::PatchImage& image) {
  return fmt::format("segments.{}.csv", image.id);
}

}  // namespace ridgeline::apps
