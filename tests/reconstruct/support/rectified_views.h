// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/support/random.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <functional>

namespace ridgeline::test {

/// Two rectified views of painted surfaces, 8 bits: the right one has `n_all` columns more, and
/// shows column x of the left one in its column x + n_all - d.
struct RectifiedViews {
  cv::Mat left, right;
};

/// A texture of `n_bands` bands, a few pixels fine.
inline cv::Mat texture(const cv::Size& size, int n_bands, std::uint64_t seed) {
  Random random(seed);
  cv::Mat image(size, CV_8UC(n_bands));
  for (int y = 0; y < size.height; ++y) {
    for (int i = 0; i < size.width * n_bands; ++i)
      image.ptr(y)[i] = static_cast<unsigned char>(random.uniform(0.0, 256.0));
  }
  cv::GaussianBlur(image, image, {5, 5}, 1.2);
  return image;
}

/// Views whose disparity at a pixel of the left one is a whole number.
inline RectifiedViews rectified_views(const cv::Size& size,
                                      int n_bands,
                                      int n_all,
                                      const std::function<int(int x, int y)>& disparity_px) {
  RectifiedViews views{cv::Mat(size, CV_8UC(n_bands)),
                       texture({size.width + n_all, size.height}, n_bands, 7)};
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const int in_right = x + n_all - disparity_px(x, y);
      for (int band = 0; band < n_bands; ++band)
        views.left.ptr(y)[x * n_bands + band] = views.right.ptr(y)[in_right * n_bands + band];
    }
  }
  return views;
}

}  // namespace ridgeline::test
