// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/colour_gradient.h"

#include "reconstruct/geometry/check.h"

#include <opencv2/imgproc.hpp>

#include <cmath>
#include <vector>

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

/// A row of structure tensors, [xx xy; xy yy], and the gradients (x, y) of the sum of the bands.
/// They are stored by component so that the compiler can process several pixels at a time.
struct TensorRow {
  explicit TensorRow(int n) : xx(n), xy(n), yy(n), x(n), y(n) {}
  std::vector<float> xx, xy, yy, x, y;
};

void sum_bands(const float* dx, const float* dy, int n_bands, TensorRow& row) {
  for (std::size_t i = 0; i < row.xx.size(); ++i, dx += n_bands, dy += n_bands) {
    float xx = 0.0F;
    float xy = 0.0F;
    float yy = 0.0F;
    float x = 0.0F;
    float y = 0.0F;
    for (int band = 0; band < n_bands; ++band) {
      xx += dx[band] * dx[band];
      xy += dx[band] * dy[band];
      yy += dy[band] * dy[band];
      x += dx[band];
      y += dy[band];
    }
    row.xx[i] = xx;
    row.xy[i] = xy;
    row.yy[i] = yy;
    row.x[i] = x;
    row.y[i] = y;
  }
}

/// The principal axis of each tensor with length sqrt(lambda_1), pointing to the same side as the
/// grey gradient.
void principal_axes_of_row(const TensorRow& row, float* axes) {
  for (std::size_t i = 0; i < row.xx.size(); ++i) {
    const float xy = row.xy[i];
    const float half_difference = 0.5F * (row.xx[i] - row.yy[i]);
    const float root = std::sqrt(half_difference * half_difference + xy * xy);
    const float strength = std::sqrt(0.5F * (row.xx[i] + row.yy[i]) + root);
    // The eigenvector is computed from the row of G - lambda I that does not suffer from
    // cancellation.
    const bool is_first = half_difference >= 0.0F;
    const float x = is_first ? half_difference + root : xy;
    const float y = is_first ? xy : root - half_difference;
    const float length = std::sqrt(x * x + y * y);
    const float scale = strength / length;
    const float axis_x = length > 0.0F ? x * scale : strength;
    const float axis_y = length > 0.0F ? y * scale : 0.0F;
    const float sign = axis_x * row.x[i] + axis_y * row.y[i] < 0.0F ? -1.0F : 1.0F;
    axes[2 * i] = sign * axis_x;
    axes[2 * i + 1] = sign * axis_y;
  }
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
  TensorRow row(image.cols);
  for (int y = 0; y < image.rows; ++y) {
    sum_bands(dx.ptr<float>(y), dy.ptr<float>(y), n_bands, row);
    principal_axes_of_row(row, gradient.ptr<float>(y));
  }
  return gradient;
}

}  // namespace ridgeline::reconstruct
