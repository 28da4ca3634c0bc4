// SPDX-License-Identifier: BSD-3-Clause
#include "apps/common/patch_views.h"

#include "apps/common/check_pair.h"
#include "io/image.h"
#include "reconstruct/views/normalised_image.h"

#include <spdlog/spdlog.h>
#include <tbb/parallel_for.h>

#include <future>
#include <utility>

namespace ridgeline::apps {
namespace {

/// Empty for a lens without distortion; the view must outlive it.
PixelMap ideal_from_image(const io::PatchImage& view) {
  if (!view.interior || view.interior->distortion.is_zero()) return {};
  return [&view](const Eigen::Vector2d& x_px) { return io::undistorted_px(view, x_px); };
}

}  // namespace

LocalFrame patch_frame(const io::PatchFile& patch) {
  const io::PatchImage& base = patch.images[0];
  const io::ImageFacts facts = io::image_facts(base.path);
  return reconstruct::local_frame(base.image_from_world, {facts.width_px, facts.height_px},
                                  patch.height_range_m);
}

cv::Mat patch_image(const io::PatchFile& patch, std::size_t i) {
  return reconstruct::normalised_image(
      io::read_image(patch.images.at(i).path, patch.max_image_mpx));
}

std::array<cv::Mat, 2> patch_images(const io::PatchFile& patch) {
  auto right = std::async(std::launch::async, [&patch] { return patch_image(patch, 1); });
  cv::Mat left = patch_image(patch, 0);
  return {std::move(left), right.get()};
}

std::vector<EdgeSegment> extract_patch_image(const io::PatchFile& patch,
                                             std::size_t i,
                                             const cv::Mat& image,
                                             const reconstruct::ExtractionOptions& options) {
  return reconstruct::extract(image, ideal_from_image(patch.images.at(i)), options);
}

reconstruct::StereoPair stereo_pair(const io::PatchFile& patch,
                                    const std::array<cv::Mat, 2>& images,
                                    const std::array<std::vector<EdgeSegment>, 2>& segments) {
  const LocalFrame frame = patch_frame(patch);
  const std::array<ProjectionMatrix, 2> cameras = io::cameras_in_local(patch, frame);
  const auto view = [&](std::size_t i) -> reconstruct::MatchView {
    return {cameras[i], images[i], segments[i], ideal_from_image(patch.images[i])};
  };
  return {{view(0), view(1)}, io::heights_in_local_m(patch, frame)};
}

std::vector<reconstruct::View> patch_views(const io::PatchFile& patch,
                                           const std::array<cv::Mat, 2>& images) {
  std::vector<reconstruct::View> views;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const io::PatchImage& image = patch.images[i];
    views.push_back({image.id, images[i], image.image_from_world, ideal_from_image(image)});
  }
  return views;
}

reconstruct::StereoPair load_pair(const io::PatchFile& patch,
                                  const reconstruct::ExtractionOptions& options,
                                  double max_y_parallax_px) {
  check_patch(patch);
  const std::array<cv::Mat, 2> images = patch_images(patch);
  if (const auto doubt = check_pair(patch, images, max_y_parallax_px)) spdlog::warn("{}", *doubt);
  std::array<std::vector<EdgeSegment>, 2> segments;
  tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t i) {
    segments[i] = extract_patch_image(patch, i, images[i], options);
  });
  return stereo_pair(patch, images, segments);
}

}  // namespace ridgeline::apps
