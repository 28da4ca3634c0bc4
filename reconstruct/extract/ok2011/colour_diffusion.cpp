// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/ok2011/colour_diffusion.h"

#include "reconstruct/geometry/check.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <array>

namespace ridgeline::reconstruct {
namespace {

/// Smoothing of the gradient that controls the diffusion, and factor for lambda, per level.
struct Level {
  double sigma_px;
  float lambda_factor;
};
constexpr std::array<Level, 3> kLevels{{{1.2, 1.0F}, {0.9, 1.2F}, {0.7, 1.4F}}};
constexpr int kStepsPerLevel = 2;
constexpr float kStep = 0.2F;

int blur_radius_px(double sigma_px) { return static_cast<int>(std::ceil(2.5 * sigma_px)); }

/// Adds the squared central differences of a band to `square`.
void add_squared_gradient(const cv::Mat& band, cv::Mat& square) {
  for (int y = 0; y < band.rows; ++y) {
    const auto* above = band.ptr<float>(std::max(0, y - 1));
    const auto* below = band.ptr<float>(std::min(band.rows - 1, y + 1));
    const auto* row = band.ptr<float>(y);
    auto* out = square.ptr<float>(y);
    for (int x = 0; x < band.cols; ++x) {
      const float dx = 0.5F * (row[std::min(band.cols - 1, x + 1)] - row[std::max(0, x - 1)]);
      const float dy = 0.5F * (below[x] - above[x]);
      out[x] += dx * dx + dy * dy;
    }
  }
}

/// Tukey's biweight of the common gradient, g = (1 - s^2 / lambda^2)^2 below lambda, otherwise 0.
cv::Mat diffusivity(const std::vector<cv::Mat>& bands, const cv::Mat& lambda, const Level& level) {
  cv::Mat g = cv::Mat::zeros(lambda.size(), CV_32FC1);
  const int width = 2 * blur_radius_px(level.sigma_px) + 1;
  cv::Mat smooth;
  for (const cv::Mat& band : bands) {
    cv::GaussianBlur(band, smooth, {width, width}, level.sigma_px, level.sigma_px,
                     cv::BORDER_REPLICATE);
    add_squared_gradient(smooth, g);
  }
  for (int y = 0; y < g.rows; ++y) {
    auto* row = g.ptr<float>(y);
    const auto* limit = lambda.ptr<float>(y);
    for (int x = 0; x < g.cols; ++x) {
      const float scale = level.lambda_factor * limit[x];
      const float below = std::max(0.0F, 1.0F - row[x] / (scale * scale));
      row[x] = below * below;
    }
  }
  return g;
}

/// One explicit step; the diffusivity between two pixels is the mean of their diffusivities.
void step(const cv::Mat& band, const cv::Mat& diffusivity, cv::Mat& next) {
  const int last = band.cols - 1;
  for (int y = 0; y < band.rows; ++y) {
    const int up = std::max(0, y - 1);
    const int down = std::min(band.rows - 1, y + 1);
    const auto* u = band.ptr<float>(y);
    const auto* u_up = band.ptr<float>(up);
    const auto* u_down = band.ptr<float>(down);
    const auto* g = diffusivity.ptr<float>(y);
    const auto* g_up = diffusivity.ptr<float>(up);
    const auto* g_down = diffusivity.ptr<float>(down);
    auto* out = next.ptr<float>(y);
    const auto at = [&](int x, int left, int right) {
      const float flux = (g[x] + g[right]) * (u[right] - u[x]) +
                         (g[x] + g[left]) * (u[left] - u[x]) + (g[x] + g_up[x]) * (u_up[x] - u[x]) +
                         (g[x] + g_down[x]) * (u_down[x] - u[x]);
      return u[x] + 0.5F * kStep * flux;
    };
    out[0] = at(0, 0, std::min(1, last));
    for (int x = 1; x < last; ++x) out[x] = at(x, x - 1, x + 1);
    if (last > 0) out[last] = at(last, last - 1, last);
  }
}

}  // namespace

int diffusion_reach_px(int levels) {
  int reach = 0;
  for (int i = 0; i < levels; ++i)
    reach += blur_radius_px(kLevels[i].sigma_px) + 1 + kStepsPerLevel;
  return reach;
}

cv::Mat colour_diffusion(const cv::Mat& image, const cv::Mat& lambda, int levels) {
  check(levels >= 1 && levels <= static_cast<int>(kLevels.size()),
        "colour_diffusion: levels = ", levels, ", must be 1 to 3");
  check(image.size() == lambda.size() && image.depth() == CV_32F && lambda.type() == CV_32FC1,
        "colour_diffusion: image and lambda must be float and of one size");
  std::vector<cv::Mat> bands;
  cv::split(image, bands);
  cv::Mat next(image.size(), CV_32FC1);
  for (int i = 0; i < levels; ++i) {
    const cv::Mat g = diffusivity(bands, lambda, kLevels[i]);
    for (cv::Mat& band : bands) {
      for (int k = 0; k < kStepsPerLevel; ++k) {
        step(band, g, next);
        std::swap(band, next);
      }
    }
  }
  cv::Mat diffused;
  cv::merge(bands, diffused);
  return diffused;
}

}  // namespace ridgeline::reconstruct
