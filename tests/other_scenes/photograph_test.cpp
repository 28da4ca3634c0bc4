// SPDX-License-Identifier: BSD-3-Clause
#include "tests/other_scenes/photograph.h"

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include <cmath>

namespace ridgeline::other {
namespace {

/// Light that rises along rows and columns, in each band in another way.
cv::Mat slopes() {
  cv::Mat light(64, 80, CV_32FC3);
  for (int row = 0; row < light.rows; ++row) {
    for (int column = 0; column < light.cols; ++column) {
      light.at<cv::Vec3f>(row, column) = {0.01F * static_cast<float>(column),
                                          0.9F - 0.01F * static_cast<float>(row),
                                          0.2F + 0.005F * static_cast<float>(row + column)};
    }
  }
  return light;
}

Film film_of(double noise) {
  return {.gamma = 1.0, .blur_sigma_px = 0.5, .read_noise = noise, .photon_noise = 0.0};
}

TEST(OtherExposure, BayerPatternLeavesGreyAndSlopesOfColourWhereTheyAre) {
  const cv::Mat grey(64, 80, CV_32FC3, cv::Scalar::all(0.4));
  for (const cv::Mat& light : {grey, slopes()}) {
    Film film = film_of(0.0);
    const cv::Mat plain = expose(light, film);
    film.bayer = true;
    const cv::Mat seen = expose(light, film);
    const cv::Rect inner(3, 3, light.cols - 6, light.rows - 6);
    // two roundings; a pixel further a slope has two or three more
    EXPECT_LE(cv::norm(seen(inner), plain(inner), cv::NORM_INF), 1.0);
  }
}

TEST(OtherExposure, BayerPatternKeepsRedInEvenRowsAndColumnsAndBlueInOddOnes) {
  const cv::Mat light(64, 80, CV_32FC3, cv::Scalar::all(0.4));
  Film film = film_of(0.1);
  const cv::Mat plain = expose(light, film);
  film.bayer = true;
  const cv::Mat seen = expose(light, film);
  int n_others = 0;
  for (int row = 0; row < light.rows; ++row) {
    for (int column = 0; column < light.cols; ++column) {
      const int own = row % 2 + column % 2;
      const auto& pixel = seen.at<cv::Vec3b>(row, column);
      EXPECT_EQ(pixel[own], plain.at<cv::Vec3b>(row, column)[own]);
      const int other = (own + 1) % 3;
      n_others += pixel[other] != plain.at<cv::Vec3b>(row, column)[other] ? 1 : 0;
    }
  }
  EXPECT_GT(n_others, 4000);  // of 5120: they come from other pixels
}

TEST(OtherExposure, JpegChangesLittleAtHighQualityAndMoreAtLow) {
  Film film = film_of(0.01);
  const cv::Mat plain = expose(slopes(), film);
  const auto rms = [&](int quality) {
    film.jpeg_quality = quality;
    return cv::norm(expose(slopes(), film), plain) /
           std::sqrt(static_cast<double>(plain.total() * 3));
  };
  const double high = rms(95);
  EXPECT_GT(high, 0.0);
  EXPECT_LT(high, 3.0);
  EXPECT_GT(rms(10), 1.5 * high);
}

}  // namespace
}  // namespace ridgeline::other
