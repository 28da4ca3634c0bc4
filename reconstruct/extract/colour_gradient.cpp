// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/colour_gradient.h"

#include "reconstruct/geometry/check.h"

#include <opencv2/imgproc.hpp>

namespace ridgeline::reconstruct {
namespace {

struct Kernels {
  cv::Mat smooth, derive;
};

/// A Gaussian of sum 1, and its derivative scaled to give 1 on a ramp of slope 1.
Kernels kernels(double sigma_px) {
  const int radius = gradient_reach_px(sigma_px);
  Kernels k{cv::Mat(1, 2 * radius + 1, CV_32F), cv::Mat(1, 2 * radius + 1, CV_32F)};
  double sum = 0.0;
  double moment = 0.0;
  for (int i = -radius; i <= radius; ++i) {
    const double g = std::exp(-0.5 * i * i / (sigma_px * sigma_px));
    k.smooth.at<float>(i + radius) = static_cast<float>(g);
    k.derive.at<float>(i + radius) = static_cast<float>(i * g);
    sum += g;
    moment += i * i * g;
  }
  k.smooth /= sum;
  k.derive /= moment;
  return k;
}

/// Principal axis of the tensor [xx xy; xy yy] with length sqrt(lambda_1).
cv::Vec2f principal_axis(float xx, float xy, float yy) {
  const float half_difference = 0.5F * (xx - yy);
  const float root = std::sqrt(half_difference * half_difference + xy * xy);
  const float lambda = 0.5F * (xx + yy) + root;
  // Of the two rows of G - lambda I, the one that is not cancelled.
  cv::Vec2f axis = half_difference >= 0.0F ? cv::Vec2f(half_difference + root, xy)
                                           : cv::Vec2f(xy, root - half_difference);
  const float length = std::sqrt(axis.dot(axis));
  return length > 0.0F ? axis * (std::sqrt(lambda) / length) : cv::Vec2f(std::sqrt(lambda), 0.0F);
}

cv::Vec2f gradient_of(const float* dx, const float* dy, int n_bands) {
  float xx = 0.0F;
  float xy = 0.0F;
  float yy = 0.0F;
  cv::Vec2f grey(0.0F, 0.0F);
  for (int band = 0; band < n_bands; ++band) {
    xx += dx[band] * dx[band];
    xy += dx[band] * dy[band];
    yy += dy[band] * dy[band];
    grey += cv::Vec2f(dx[band], dy[band]);
  }
  const cv::Vec2f axis = principal_axis(xx, xy, yy);
  return axis.dot(grey) < 0.0F ? -axis : axis;
}

}  // namespace

int gradient_reach_px(double sigma_px) { return static_cast<int>(std::ceil(3.5 * sigma_px)); }

cv::Mat colour_gradient(const cv::Mat& image, double sigma_px) {
  check(image.depth() == CV_32F && image.channels() <= 4,
        "colour_gradient: the image must have 1 to 4 bands of float");
  const Kernels k = kernels(sigma_px);
  cv::Mat dx;
  cv::Mat dy;
  cv::sepFilter2D(image, dx, CV_32F, k.derive, k.smooth, {-1, -1}, 0.0, cv::BORDER_REPLICATE);
  cv::sepFilter2D(image, dy, CV_32F, k.smooth, k.derive, {-1, -1}, 0.0, cv::BORDER_REPLICATE);
  const int n_bands = image.channels();
  cv::Mat gradient(image.size(), CV_32FC2);
  for (int y = 0; y < image.rows; ++y) {
    const auto* row_dx = dx.ptr<float>(y);
    const auto* row_dy = dy.ptr<float>(y);
    auto* row = gradient.ptr<cv::Vec2f>(y);
    for (int x = 0; x < image.cols; ++x) {
      row[x] = gradient_of(row_dx, row_dy, n_bands);
      row_dx += n_bands;
      row_dy += n_bands;
    }
  }
  return gradient;
}

}  // namespace ridgeline::reconstruct
