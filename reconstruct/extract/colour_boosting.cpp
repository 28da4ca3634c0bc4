// SPDX-License-Identifier: BSD-3-Clause
#include "reconstruct/extract/colour_boosting.h"

#include <Eigen/Eigenvalues>
#include <opencv2/core.hpp>

namespace ridgeline::reconstruct {
namespace {

constexpr double kLargestRatio = 10.0;

/// Sum over the pixels of df df^T, df the differences to the right and below.
Eigen::Matrix4d derivative_scatter(const cv::Mat& image) {
  const int n_bands = image.channels();
  Eigen::Matrix4d scatter = Eigen::Matrix4d::Zero();
  for (int y = 0; y + 1 < image.rows; ++y) {
    const auto* row = image.ptr<float>(y);
    const auto* below = image.ptr<float>(y + 1);
    for (int x = 0; x + 1 < image.cols; ++x) {
      Eigen::Vector4d right_step = Eigen::Vector4d::Zero();
      Eigen::Vector4d down_step = Eigen::Vector4d::Zero();
      for (int band = 0; band < n_bands; ++band) {
        const int i = x * n_bands + band;
        right_step[band] = row[i + n_bands] - row[i];
        down_step[band] = below[i] - row[i];
      }
      scatter += right_step * right_step.transpose() + down_step * down_step.transpose();
    }
  }
  return scatter;
}

}  // namespace

cv::Mat colour_boosted(const cv::Mat& image) {
  const int n_bands = image.channels();
  if (n_bands == 1) return image;
  const Eigen::MatrixXd scatter = derivative_scatter(image).topLeftCorner(n_bands, n_bands);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(scatter);
  const double largest = solver.eigenvalues()[n_bands - 1];
  if (!(largest > 0.0)) return image;
  const double mean = scatter.trace() / n_bands;
  cv::Mat axes(n_bands, n_bands, CV_32F);
  for (int i = 0; i < n_bands; ++i) {
    const double variance =
        std::max(solver.eigenvalues()[i], largest / (kLargestRatio * kLargestRatio));
    for (int k = 0; k < n_bands; ++k) {
      axes.at<float>(i, k) =
          static_cast<float>(std::sqrt(mean / variance) * solver.eigenvectors()(k, i));
    }
  }
  cv::Mat boosted;
  cv::transform(image, boosted, axes);
  return boosted;
}

}  // namespace ridgeline::reconstruct
