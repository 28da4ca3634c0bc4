// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/edge_detection.h"

#include "reconstruct/scene/normalised_image.h"
#include "tests/reconstruct/extract/ok2011/blurred_scene.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include <map>

namespace ridgeline::reconstruct {
namespace {

std::map<std::pair<int, int>, EdgePixel> by_place(const std::vector<EdgePixel>& pixels, int shift) {
  std::map<std::pair<int, int>, EdgePixel> all;
  for (const EdgePixel& pixel : pixels) all.emplace(std::pair(pixel.x + shift, pixel.y), pixel);
  return all;
}

std::vector<EdgePixel> detected(const cv::Mat& image) {
  const ExtractOptions options;
  return detected_edge_pixels(image, gradient_image(image, options).noise, options);
}

TEST(DetectedEdgePixels, DoNotDependOnWhereTheTilesLie) {
  // the image is shifted by one block of the noise grid, which is no multiple of the tiles
  constexpr int kShift_px = NoiseGrid::kBlock_px;
  const cv::Mat image = normalised_image(test::blurred_scene(7).raw);
  const auto whole = by_place(detected(image), 0);
  const auto part = by_place(detected(image.colRange(kShift_px, image.cols).clone()), kShift_px);
  int n = 0;
  int n_same = 0;
  for (const auto& [place, pixel] : whole) {
    if (place.first < 2 * kShift_px) continue;  // the border of the part has another noise
    const auto other = part.find(place);
    const Eigen::Vector2f shift(static_cast<float>(kShift_px), 0.0F);
    constexpr float kRounding_px = 1e-3F;
    ++n;
    if (other == part.end()) continue;
    const Eigen::Vector2f difference = other->second.position_px + shift - pixel.position_px;
    if (difference.norm() < kRounding_px) ++n_same;
  }
  EXPECT_GT(n, 1000);
  EXPECT_EQ(n_same, n);
}

TEST(NoiseGrid, IsTheNoiseOfTheGradientBesideStrongEdges) {
  cv::Mat gradient(256, 256, CV_32FC2);
  cv::RNG random(4);
  random.fill(gradient, cv::RNG::NORMAL, 0.0, 0.01);
  gradient.col(100).setTo(cv::Scalar(0.5, 0.0));
  const NoiseGrid noise(gradient, 0.0005F);
  EXPECT_NEAR(noise.at(100, 128), 0.01F, 0.0005F);
  EXPECT_NEAR(noise.at(0, 0), 0.01F, 0.0005F);
}

TEST(NoiseGrid, FollowsTheNoiseOfTheParts) {
  cv::Mat gradient(256, 256, CV_32FC2);
  cv::RNG random(4);
  random.fill(gradient, cv::RNG::NORMAL, 0.0, 0.01);
  gradient.colRange(128, 256) *= 3.0;
  const NoiseGrid noise(gradient, 0.0005F);
  EXPECT_NEAR(noise.at(20, 128), 0.01F, 0.0005F);
  EXPECT_NEAR(noise.at(240, 128), 0.03F, 0.0015F);
  // halfway between the middles of two blocks
  EXPECT_NEAR(noise.at(128, 128), 0.02F, 0.001F);
}

TEST(NoiseGrid, IsNeverLessThanTheLowest) {
  const NoiseGrid noise(cv::Mat(10, 10, CV_32FC2, cv::Scalar::all(0)), 0.0005F);
  EXPECT_EQ(noise.at(5, 5), 0.0005F);
}

}  // namespace
}  // namespace ridgeline::reconstruct
