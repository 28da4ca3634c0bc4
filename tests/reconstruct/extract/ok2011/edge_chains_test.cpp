// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/edge_chains.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

using testing::SizeIs;

const cv::Size kSize_px(40, 40);

EdgePixel pixel(int x, int y, const Eigen::Vector2f& gradient) {
  return {x, y, Eigen::Vector2f(static_cast<float>(x), static_cast<float>(y)), gradient};
}

std::vector<Chain> chains_of(const std::vector<EdgePixel>& pixels) {
  return linked_chains(pixels, edge_pixel_index(pixels, kSize_px));
}

TEST(LinkedChains, ARowOfPixelsIsOneChainFromEndToEnd) {
  std::vector<EdgePixel> pixels;
  for (int x = 5; x < 30; ++x) pixels.push_back(pixel(x, 10, {0, 1}));
  const std::vector<Chain> chains = chains_of(pixels);
  ASSERT_THAT(chains, SizeIs(1));
  for (int i = 0; i < 25; ++i) EXPECT_EQ(chains[0][i], i);
}

TEST(LinkedChains, ASenseOfTheGradientThatFlipsDoesNotBreakAChain) {
  std::vector<EdgePixel> pixels;
  for (int x = 5; x < 30; ++x) pixels.push_back(pixel(x, 10, {0, x % 3 == 0 ? 1.0F : -1.0F}));
  EXPECT_THAT(chains_of(pixels), SizeIs(1));
}

TEST(LinkedChains, BridgesOnePixelButNotTwo) {
  std::vector<EdgePixel> one;
  std::vector<EdgePixel> two;
  for (int x = 5; x < 30; ++x) {
    if (x != 15) one.push_back(pixel(x, 10, {0, 1}));
    if (x != 15 && x != 16) two.push_back(pixel(x, 10, {0, 1}));
  }
  EXPECT_THAT(chains_of(one), SizeIs(1));
  EXPECT_THAT(chains_of(two), SizeIs(2));
}

TEST(LinkedChains, GoesStraightThroughAJunction) {
  std::vector<EdgePixel> pixels;
  for (int x = 5; x < 30; ++x) pixels.push_back(pixel(x, 10, {0, 1}));
  for (int y = 11; y < 25; ++y) pixels.push_back(pixel(17, y, {1, 0}));
  const std::vector<Chain> chains = chains_of(pixels);
  ASSERT_THAT(chains, SizeIs(2));
  EXPECT_THAT(chains[0], SizeIs(25));
  EXPECT_THAT(chains[1], SizeIs(14));
}

TEST(LinkedChains, ACircleIsOneChain) {
  std::vector<EdgePixel> pixels;
  cv::Mat seen = cv::Mat::zeros(kSize_px, CV_8U);
  for (int i = 0; i < 720; ++i) {
    const float a = static_cast<float>(i) * 0.5F * static_cast<float>(CV_PI) / 180.0F;
    const Eigen::Vector2f n(std::cos(a), std::sin(a));
    const Eigen::Vector2f x = Eigen::Vector2f(20, 20) + 12.0F * n;
    const cv::Point p(cvRound(x.x()), cvRound(x.y()));
    if (seen.at<std::uint8_t>(p) != 0) continue;
    seen.at<std::uint8_t>(p) = 1;
    pixels.push_back({p.x, p.y, x, n});
  }
  std::size_t longest = 0;
  for (const Chain& chain : chains_of(pixels)) longest = std::max(longest, chain.size());
  EXPECT_GT(longest, pixels.size() * 9 / 10);
}

TEST(LinkedChains, EveryPixelIsInOneChain) {
  std::vector<EdgePixel> pixels;
  for (int y = 1; y < 39; ++y) {
    for (int x = 1; x < 39; ++x) {
      const float a = 0.1F * static_cast<float>(x * y % 31);
      if ((x * 7 + y * 3) % 4 == 0) pixels.push_back(pixel(x, y, {std::cos(a), std::sin(a)}));
    }
  }
  std::vector<int> n(pixels.size(), 0);
  for (const Chain& chain : chains_of(pixels)) {
    for (const int i : chain) ++n[i];
  }
  EXPECT_THAT(n, testing::Each(1));
}

TEST(LinkedChains, NoPixelsAreNoChains) { EXPECT_THAT(chains_of({}), SizeIs(0)); }

}  // namespace
}  // namespace ridgeline::reconstruct
