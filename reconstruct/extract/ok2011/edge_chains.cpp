// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/edge_chains.h"

#include <opencv2/core.hpp>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>

namespace ridgeline::reconstruct {
namespace {

constexpr int kReach_px = 2;
constexpr float kMaxTurnCosine = 0.8F;    // 37 degrees between the edges of two pixels
constexpr float kMaxDetourCosine = 0.7F;  // 45 degrees between an edge and the step along it

/// Neighbours ahead [0] and behind [1]; -1 if there is none.
using Links = std::array<int, 2>;

Eigen::Vector2f along(const EdgePixel& pixel) {
  return Eigen::Vector2f(-pixel.gradient.y(), pixel.gradient.x()).normalized();
}

/// The side of `pixel` that lies in the direction of `step`: 0 ahead, 1 behind.
int side_of(const EdgePixel& pixel, const Eigen::Vector2f& step) {
  return along(pixel).dot(step) > 0.0F ? 0 : 1;
}

/// The nearest pixels ahead and behind that may continue the edge through pixel i.
Links nearest(int i, std::span<const EdgePixel> pixels, const cv::Mat& index) {
  const EdgePixel& pixel = pixels[i];
  const Eigen::Vector2f direction = along(pixel);
  Links links{-1, -1};
  std::array<float, 2> best{1e9F, 1e9F};
  for (int y = std::max(0, pixel.y - kReach_px); y <= std::min(index.rows - 1, pixel.y + kReach_px);
       ++y) {
    for (int x = std::max(0, pixel.x - kReach_px);
         x <= std::min(index.cols - 1, pixel.x + kReach_px); ++x) {
      const int j = index.at<int>(y, x);
      if (j < 0 || j == i) continue;
      const Eigen::Vector2f step = pixels[j].position_px - pixel.position_px;
      const float ahead = direction.dot(step);
      const float distance = step.norm();
      if (std::abs(ahead) < kMaxDetourCosine * distance) continue;
      if (std::abs(direction.dot(along(pixels[j]))) < kMaxTurnCosine) continue;
      const int side = ahead > 0.0F ? 0 : 1;
      // A step along the edge is preferred to an equally long oblique one.
      const float cost = 2.0F * distance - std::abs(ahead);
      if (cost < best[side]) {
        best[side] = cost;
        links[side] = j;
      }
    }
  }
  return links;
}

/// The links of each pixel that both of its ends have selected.
std::vector<Links> mutual_links(std::span<const EdgePixel> pixels, const cv::Mat& index) {
  std::vector<Links> named(pixels.size());
  std::vector<Links> links(pixels.size(), Links{-1, -1});
  const tbb::blocked_range<int> all(0, static_cast<int>(pixels.size()), 1024);
  tbb::parallel_for(all, [&](const auto& range) {
    for (int i = range.begin(); i != range.end(); ++i) named[i] = nearest(i, pixels, index);
  });
  tbb::parallel_for(all, [&](const auto& range) {
    for (int i = range.begin(); i != range.end(); ++i) {
      for (int side = 0; side < 2; ++side) {
        const int j = named[i][side];
        if (j < 0) continue;
        const Eigen::Vector2f back = pixels[i].position_px - pixels[j].position_px;
        if (named[j][side_of(pixels[j], back)] == i) links[i][side] = j;
      }
    }
  });
  return links;
}

/// Walks from pixel i until the chain ends or reaches a pixel that is already taken.
Chain walk(int i, const std::vector<Links>& links, std::vector<char>& taken) {
  Chain chain;
  int previous = -1;
  while (i >= 0 && taken[i] == 0) {
    taken[i] = 1;
    chain.push_back(i);
    const int next = links[i][0] != previous && links[i][0] >= 0 ? links[i][0] : links[i][1];
    if (next == previous) break;
    previous = i;
    i = next;
  }
  return chain;
}

}  // namespace

cv::Mat edge_pixel_index(std::span<const EdgePixel> pixels, const cv::Size& size_px) {
  cv::Mat index(size_px, CV_32SC1, cv::Scalar(-1));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    index.at<int>(pixels[i].y, pixels[i].x) = static_cast<int>(i);
  }
  return index;
}

std::vector<Chain> linked_chains(std::span<const EdgePixel> pixels, const cv::Mat& index) {
  const std::vector<Links> links = mutual_links(pixels, index);
  std::vector<char> taken(pixels.size(), 0);
  std::vector<Chain> chains;
  for (const bool only_ends : {true, false}) {
    for (int i = 0; i < static_cast<int>(pixels.size()); ++i) {
      const bool is_end = links[i][0] < 0 || links[i][1] < 0;
      if (taken[i] == 0 && (is_end || !only_ends)) chains.push_back(walk(i, links, taken));
    }
  }
  return chains;
}

}  // namespace ridgeline::reconstruct
