// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/edge_detection.h"

#include "reconstruct/extract/ok2011/colour_diffusion.h"
#include "reconstruct/extract/ok2011/colour_gradient.h"
#include "reconstruct/geometry/interruption.h"

#include <opencv2/core.hpp>
#include <tbb/parallel_for.h>

namespace ridgeline::reconstruct {
namespace {

constexpr int kSearchTile_px = 256;

/// Ours: Ok et al. 2011, section 2, also diffuse the image but give no values.
constexpr int kDiffusionLevels = 3;
constexpr double kDiffusionLambda = 2.0;  ///< multiple of the noise at which edges stop it

/// Lower bound on the noise: about an eighth of an 8-bit grey level per pixel. Saturated or
/// computer-generated areas have almost no gradient.
constexpr float kMinNoise = 0.0005F;

std::vector<cv::Rect> tiles(const cv::Size& size_px) {
  std::vector<cv::Rect> all;
  const cv::Rect whole({0, 0}, size_px);
  for (int y = 0; y < size_px.height; y += kSearchTile_px) {
    for (int x = 0; x < size_px.width; x += kSearchTile_px) {
      all.push_back(cv::Rect(x, y, kSearchTile_px, kSearchTile_px) & whole);
    }
  }
  return all;
}

cv::Rect grown(const cv::Rect& tile, int margin_px, const cv::Size& size_px) {
  return cv::Rect(tile.x - margin_px, tile.y - margin_px, tile.width + 2 * margin_px,
                  tile.height + 2 * margin_px) &
         cv::Rect({0, 0}, size_px);
}

/// The gradient of an image after diffusion.
cv::Mat diffused_gradient(const cv::Mat& image,
                          const cv::Mat& noise,
                          const ExtractOptions& options) {
  if (!options.diffusion) return colour_gradient(image, options.gradient_sigma_px);
  const cv::Mat lambda = kDiffusionLambda * noise;
  return colour_gradient(colour_diffusion(image, lambda, kDiffusionLevels),
                         options.gradient_sigma_px);
}

std::vector<EdgePixel> edge_pixels_of_tile(const cv::Mat& image,
                                           const cv::Rect& tile,
                                           const NoiseGrid& noise,
                                           const ExtractOptions& options) {
  const int margin_px = (options.diffusion ? diffusion_reach_px(kDiffusionLevels) : 0) +
                        gradient_reach_px(options.gradient_sigma_px) + 1;
  const cv::Rect block = grown(tile, margin_px, image.size());
  const cv::Mat noise_in_block = noise.in(block);
  const cv::Mat gradient = diffused_gradient(image(block), noise_in_block, options);
  const cv::Rect inner(1, 1, image.cols - 2, image.rows - 2);
  const cv::Rect searched = tile & inner;
  const Eigen::Vector2f origin(static_cast<float>(block.x), static_cast<float>(block.y));
  std::vector<EdgePixel> pixels;
  for (int y = searched.y; y < searched.br().y; ++y) {
    const auto* noise_in_row = noise_in_block.ptr<float>(y - block.y);
    for (int x = searched.x; x < searched.br().x; ++x) {
      const float threshold =
          static_cast<float>(options.low_noise_factor) * noise_in_row[x - block.x];
      auto pixel = edge_pixel_at(gradient, x - block.x, y - block.y, threshold);
      if (!pixel) continue;
      pixel->x = x;
      pixel->y = y;
      pixel->position_px += origin;
      pixels.push_back(*pixel);
    }
  }
  return pixels;
}

}  // namespace

GradientImage gradient_image(const ImagePart& part, const ExtractOptions& options) {
  const cv::Mat& image = part.pixels;
  cv::Mat gradient(image.size(), CV_32FC2);
  const std::vector<cv::Rect> all = tiles(image.size());
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
    Interruption::check();
    // The filter also uses the pixels around the tile, because the tile is a submatrix of the
    // image.
    colour_gradient(image(all[i]), options.gradient_sigma_px).copyTo(gradient(all[i]));
  });
  return {gradient, NoiseGrid(gradient, kMinNoise, part.corner_px, part.has_data)};
}

std::vector<EdgePixel> detected_edge_pixels(const cv::Mat& image,
                                            const NoiseGrid& noise,
                                            const ExtractOptions& options) {
  const std::vector<cv::Rect> all = tiles(image.size());
  std::vector<std::vector<EdgePixel>> found(all.size());
  tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
    found[i] = edge_pixels_of_tile(image, all[i], noise, options);
  });
  std::vector<EdgePixel> pixels;
  for (const auto& part : found) pixels.insert(pixels.end(), part.begin(), part.end());
  return pixels;
}

}  // namespace ridgeline::reconstruct
